#include <graze/bvh/error.h>
#include <graze/engine/compare/judge/shrink/reductions.h>
#include <graze/engine/compare/judge/shrink/shape_numbers.h>
#include <graze/engine/compare/judge/shrink/shrink.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace graze::compare {
namespace {

Mesh placed_triangle(const CaseMesh& mesh, std::uint32_t index) {
  const Triangle t = place(mesh.pose, mesh.mesh.triangle(index));
  return {std::array<Eigen::Vector3d, 3>{t.a, t.b, t.c},
          std::array<TriangleIndices, 1>{{{0, 1, 2}}}};
}

/// Returns the triangles of a mesh, the nearest to a point first: by their boxes, in double, as
/// this only says where to look first. Those that are equally near are in the order of the mesh.
Indices nearest_first(const CaseMesh& mesh, const Eigen::Vector3d& point) {
  const std::size_t count = mesh.mesh.triangles().size();
  std::vector<double> squares(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle t = place(mesh.pose, mesh.mesh.triangle(i));
    const Eigen::Vector3d low = t.a.cwiseMin(t.b).cwiseMin(t.c);
    const Eigen::Vector3d high = t.a.cwiseMax(t.b).cwiseMax(t.c);
    squares[i] = (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
  }
  Indices order = all_indices(count);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(squares[a], a) < std::pair(squares[b], b);
  });
  return order;
}

/// Returns so many of the first, in the order of the mesh.
Indices first_of(const Indices& order, std::size_t count) {
  const std::size_t end = std::min(count, order.size());
  Indices some(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(end));
  std::sort(some.begin(), some.end());
  return some;
}

/// Returns the middle without overflow.
Eigen::Vector3d middle_of(const CaseMesh& mesh, std::uint32_t index) {
  const Triangle t = place(mesh.pose, mesh.mesh.triangle(index));
  return t.a / 3 + t.b / 3 + t.c / 3;
}

/// Returns another mesh in the same pose and motion.
CaseMesh with_mesh(const CaseMesh& before, const Mesh& mesh) {
  CaseMesh after(mesh, before.pose);
  after.course = before.course;
  return after;
}

class Shrinking {
 public:
  Shrinking(const Case& query, const MeshCase& meshes, const StillWrong& is_still_wrong)
      : best_(query), meshes_(meshes), is_still_wrong_(is_still_wrong) {
    best_.answer.reset();
  }

  Case take() { return best_; }

  /// Tries the two triangles as they are placed. Nothing is asked about the motion of such
  /// triangles.
  bool try_placed(const TrianglePair& pair) {
    if (best_.ask == Ask::FirstContact || best_.ask == Ask::Free) return false;
    return try_meshes(CaseMesh(placed_triangle(meshes_.a, pair.a), Pose::Identity()),
                      CaseMesh(placed_triangle(meshes_.b, pair.b), Pose::Identity()));
  }

  bool try_parts(const Indices& triangles_a, const Indices& triangles_b) {
    return try_meshes(with_mesh(meshes_.a, part_of(meshes_.a.mesh, triangles_a)),
                      with_mesh(meshes_.b, part_of(meshes_.b.mesh, triangles_b)));
  }

  /// Takes triangles away, now from one mesh, now from the other, until none can go.
  void halve(const std::optional<TrianglePair>& culprit) {
    Indices a = all_indices(meshes_.a.mesh.triangles().size());
    Indices b = all_indices(meshes_.b.mesh.triangles().size());
    if (culprit) grow(*culprit, a, b);
    for (bool is_smaller = true; is_smaller;) {
      is_smaller = take_away(a, [&](const Indices& part) { return try_parts(part, b); });
      is_smaller |= take_away(b, [&](const Indices& part) { return try_parts(a, part); });
    }
    if (a.size() == 1 && b.size() == 1) try_placed({a[0], b[0]});
  }

  /// Puts in the place of all triangles those about the culprit, if so many of them show it.
  void grow(const TrianglePair& culprit, Indices& a, Indices& b) {
    const Eigen::Vector3d point =
        middle_of(meshes_.a, culprit.a) / 2 + middle_of(meshes_.b, culprit.b) / 2;
    const Indices order_a = nearest_first(meshes_.a, point);
    const Indices order_b = nearest_first(meshes_.b, point);
    for (std::size_t count = 4; count < std::max(a.size(), b.size()); count *= 4) {
      Indices some_a = first_of(order_a, count);
      Indices some_b = first_of(order_b, count);
      if (!try_parts(some_a, some_b)) continue;
      a = std::move(some_a);
      b = std::move(some_b);
      return;
    }
  }

  /// Takes digits from coordinates: each gets the coarsest rounding that shows the same.
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

  void simplify(std::size_t corner, int axis) {
    const auto& before = std::get<CaseMesh>(corner < 3 ? best_.a : *best_.b);
    const double value = before.mesh.vertices()[corner % 3][axis];
    shorten(value, [&](double coarse) {
      Case candidate = best_;
      auto& mesh = std::get<CaseMesh>(corner < 3 ? candidate.a : *candidate.b);
      const auto list = mesh.mesh.vertices();
      std::vector<Eigen::Vector3d> vertices(list.begin(), list.end());
      vertices[corner % 3][axis] = coarse;
      try {
        mesh = with_mesh(mesh, Mesh(vertices, mesh.mesh.triangles()));
      } catch (const Error&) {  // arrays that are no mesh are not tried
        return false;
      }
      return try_case(std::move(candidate));
    });
  }

  Case best_;
  const MeshCase& meshes_;
  const StillWrong& is_still_wrong_;
};

}  // namespace

Case shrink(const Case& query, const std::optional<TrianglePair>& culprit,
            const StillWrong& is_still_wrong, const ShrinkSettings& settings) {
  const std::optional<MeshCase> meshes = as_meshes(query);
  const auto begin_search = [&] {
    if (settings.before_search) settings.before_search();
  };
  if (as_bodies(query)) {
    begin_search();
    return shrink_bodies(query, is_still_wrong);
  }
  if (!meshes) return query;
  Shrinking shrinking(query, *meshes, is_still_wrong);
  try {
    const bool is_pair = culprit && (shrinking.try_placed(*culprit) ||
                                     shrinking.try_parts({culprit->a}, {culprit->b}));
    if (!is_pair) {
      begin_search();
      shrinking.halve(culprit);
    }
    shrinking.simplify();
  } catch (const ShrinkingStopped&) {  // the best so far is true
  }
  return shrinking.take();
}

}  // namespace graze::compare
