#include <graze/engine/compare/judge/shrink.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace graze::compare {
namespace {

using Indices = std::vector<std::uint32_t>;

Mesh part_of(const Mesh& mesh, const Indices& triangles) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> indices;
  for (const std::uint32_t i : triangles) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const Triangle t = mesh.triangle(i);
    vertices.insert(vertices.end(), {t.a, t.b, t.c});
    indices.push_back({first, first + 1, first + 2});
  }
  return {vertices, indices};
}

Mesh placed_triangle(const CaseMesh& mesh, std::uint32_t index) {
  const Triangle t = place(mesh.pose, mesh.mesh.triangle(index));
  return {std::array<Eigen::Vector3d, 3>{t.a, t.b, t.c},
          std::array<TriangleIndices, 1>{{{0, 1, 2}}}};
}

class Shrinking {
 public:
  Shrinking(const Case& query, const MeshCase& meshes, const StillWrong& is_still_wrong)
      : best_(query), meshes_(meshes), is_still_wrong_(is_still_wrong) {
    best_.answer.reset();
  }

  Case take() { return best_; }

  bool try_placed(const TrianglePair& pair) {
    return try_meshes(CaseMesh(placed_triangle(meshes_.a, pair.a), Pose::Identity()),
                      CaseMesh(placed_triangle(meshes_.b, pair.b), Pose::Identity()));
  }

  bool try_parts(const Indices& triangles_a, const Indices& triangles_b) {
    return try_meshes(CaseMesh(part_of(meshes_.a.mesh, triangles_a), meshes_.a.pose),
                      CaseMesh(part_of(meshes_.b.mesh, triangles_b), meshes_.b.pose));
  }

  /// Takes triangles away, now from one mesh, now from the other, until none can go.
  void halve() {
    Indices a = all(meshes_.a.mesh);
    Indices b = all(meshes_.b.mesh);
    for (bool is_smaller = true; is_smaller;) {
      is_smaller = halve(a, [&](const Indices& part) { return try_parts(part, b); });
      is_smaller |= halve(b, [&](const Indices& part) { return try_parts(a, part); });
    }
    if (a.size() == 1 && b.size() == 1) try_placed({a[0], b[0]});
  }

  /// Coordinates with fewer digits: of each the coarsest rounding that shows the same.
  void simplify() {
    auto* a = std::get_if<CaseMesh>(&best_.a);
    auto* b = best_.b ? std::get_if<CaseMesh>(&*best_.b) : nullptr;
    if (a == nullptr || b == nullptr) return;
    if (a->mesh.triangles().size() != 1 || b->mesh.triangles().size() != 1) return;
    for (std::size_t corner = 0; corner < 6; ++corner) {
      for (int axis = 0; axis < 3; ++axis)
        simplify(corner, axis);
    }
  }

 private:
  static Indices all(const Mesh& mesh) {
    Indices indices(mesh.triangles().size());
    std::iota(indices.begin(), indices.end(), 0U);
    return indices;
  }

  bool try_case(Case candidate) {
    if (!is_still_wrong_(candidate)) return false;
    best_ = std::move(candidate);
    return true;
  }

  bool try_meshes(const CaseMesh& a, const CaseMesh& b) {
    Case candidate = best_;
    candidate.a = a;
    candidate.b = b;
    return try_case(std::move(candidate));
  }

  template <typename Try>
  static bool halve(Indices& indices, Try&& try_part) {
    const std::size_t before = indices.size();
    for (std::size_t step = (indices.size() + 1) / 2; step > 0 && indices.size() > 1;) {
      bool is_smaller = false;
      for (std::size_t first = 0; first < indices.size() && indices.size() > 1;) {
        const std::size_t last = std::min(first + step, indices.size());
        Indices rest(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(first));
        rest.insert(rest.end(), indices.begin() + static_cast<std::ptrdiff_t>(last), indices.end());
        if (!rest.empty() && try_part(rest)) {
          indices = std::move(rest);
          is_smaller = true;
        } else {
          first = last;
        }
      }
      step = step == 1 && !is_smaller ? 0 : std::max<std::size_t>(step / 2, 1);
    }
    return indices.size() < before;
  }

  void simplify(std::size_t corner, int axis) {
    for (const int digits : {0, 1, 4, 12, 24}) {
      Case candidate = best_;
      auto& mesh = std::get<CaseMesh>(corner < 3 ? candidate.a : *candidate.b);
      const auto list = mesh.mesh.vertices();
      std::vector<Eigen::Vector3d> vertices(list.begin(), list.end());
      double& value = vertices[corner % 3][axis];
      const double coarse = digits == 0 ? 0 : rounded(value, digits);
      if (coarse == value) return;
      value = coarse;
      mesh = CaseMesh(Mesh(vertices, mesh.mesh.triangles()), mesh.pose);
      if (try_case(std::move(candidate))) return;
    }
  }

  static double rounded(double value, int digits) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(fraction, digits)), exponent - digits);
  }

  Case best_;
  const MeshCase& meshes_;
  const StillWrong& is_still_wrong_;
};

}  // namespace

Case shrink(const Case& query, const std::optional<TrianglePair>& culprit,
            const StillWrong& is_still_wrong) {
  const std::optional<MeshCase> meshes = as_meshes(query);
  if (!meshes) return query;
  Shrinking shrinking(query, *meshes, is_still_wrong);
  const bool is_pair = culprit && (shrinking.try_placed(*culprit) ||
                                   shrinking.try_parts({culprit->a}, {culprit->b}));
  if (!is_pair) shrinking.halve();
  shrinking.simplify();
  return shrinking.take();
}

}  // namespace graze::compare
