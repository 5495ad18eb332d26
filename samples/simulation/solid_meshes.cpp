#include "samples/simulation/solid_meshes.h"

#include <graze/bvh/error.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace graze::samples {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using Profile = std::vector<std::array<double, 2>>;  // radius and height, ascending, metres

struct Growing {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;

  std::uint32_t add(const Vector3d& vertex) {
    vertices.push_back(vertex);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
  /// Adds a polygon that is convex, as a fan from its first corner.
  void add_polygon(std::span<const std::uint32_t> corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
  Mesh mesh() const { return {vertices, std::span<const TriangleIndices>(triangles)}; }
};

Mesh box_surface(const Vector3d& half, int cells) {
  using GridPlace = std::array<int, 3>;
  Growing box;
  std::map<GridPlace, std::uint32_t> known;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    for (const int side : {0, cells}) {
      const auto corner = [&](int i, int j) {
        GridPlace place{};
        place[k] = side, place[u] = i, place[v] = j;
        const auto [at, is_new] = known.try_emplace(place, 0);
        if (is_new) {
          const Vector3d share(place[0], place[1], place[2]);
          at->second = box.add(half.cwiseProduct(2.0 / cells * share - Vector3d::Ones()));
        }
        return at->second;
      };
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          std::array square{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
          if (side == 0) std::swap(square[1], square[3]);
          box.add_polygon(square);
        }
      }
    }
  }
  return box.mesh();
}

/// Turns the profile about z. It is closed where it begins and ends: on the axis, or by a flat
/// polygon.
Mesh turned(const Profile& profile, int sectors, const Vector3d& stretch, const Vector3d& centre) {
  Growing solid;
  std::vector<std::vector<std::uint32_t>> rings;
  for (const auto& [radius, height] : profile) {
    std::vector<std::uint32_t>& ring = rings.emplace_back();
    for (int i = 0; i < sectors; ++i) {
      const double angle = 2 * pi * (i + 0.5) / sectors;  // a strip faces -x where they are even
      const Vector3d at(radius * std::cos(angle), radius * std::sin(angle), height);
      if (radius > 0 || i == 0) {
        ring.push_back(solid.add(centre + stretch.cwiseProduct(at)));
      } else {
        ring.push_back(ring[0]);
      }
    }
  }
  const auto count = static_cast<std::size_t>(sectors);
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = (i + 1) % count;
      const std::uint32_t a = rings[r][i], b = rings[r][j];
      const std::uint32_t c = rings[r + 1][j], d = rings[r + 1][i];
      if (a != b) solid.triangles.push_back({a, b, c});
      if (c != d) solid.triangles.push_back({a, c, d});
    }
  }
  if (profile.back()[0] > 0) solid.add_polygon(rings.back());
  if (profile.front()[0] > 0) {
    solid.add_polygon(std::vector<std::uint32_t>(rings.front().rbegin(), rings.front().rend()));
  }
  return solid.mesh();
}

/// Returns the profile of a ball of radius 1, or of two half balls, each moved outward by so much.
Profile ball(double radius, double apart, int rings) {
  Profile profile;
  for (int i = 0; i <= rings; ++i) {
    const double angle = pi * i / rings;
    const bool is_pole = i == 0 || i == rings;
    const double height = -radius * std::cos(angle);
    const double wide = is_pole ? 0 : radius * std::sin(angle);
    if (2 * i < rings) profile.push_back({wide, height - apart});
    if (2 * i == rings) {
      profile.push_back({radius, -apart});
      if (apart > 0) profile.push_back({radius, apart});
    }
    if (2 * i > rings) profile.push_back({wide, height + apart});
  }
  return profile;
}

Mesh hull_surface(const ConvexHull& hull) {
  Growing solid;
  for (std::size_t i = 0; i < hull.vertex_count(); ++i)
    solid.add(hull.vertex(i));
  for (std::size_t i = 0; i < hull.facet_count(); ++i)
    solid.add_polygon(hull.facet(i));
  return solid.mesh();
}

}  // namespace

Mesh surface_of(const Shape& shape, const Fineness& fineness) {
  const Vector3d plain = Vector3d::Ones(), origin = Vector3d::Zero();
  if (const auto* s = shape.as<Sphere>()) {
    return turned(ball(s->radius, 0, fineness.rings), fineness.sectors, plain, s->centre);
  }
  if (const auto* s = shape.as<Box>()) return box_surface(s->half_extents, fineness.cells);
  if (const auto* s = shape.as<Capsule>()) {
    return turned(ball(s->radius, s->half_length, fineness.rings), fineness.sectors, plain, origin);
  }
  if (const auto* s = shape.as<Cylinder>()) {
    const double h = s->half_height;
    return turned({{s->radius, -h}, {s->radius, h}}, fineness.sectors, plain, origin);
  }
  if (const auto* s = shape.as<Cone>()) {
    const double h = s->half_height;
    return turned({{s->radius, -h}, {0, h}}, fineness.sectors, plain, origin);
  }
  if (const auto* s = shape.as<Ellipsoid>()) {
    return turned(ball(1, 0, fineness.rings), fineness.sectors, s->semi_axes, s->centre);
  }
  if (const auto* s = shape.as<ConvexHull>()) return hull_surface(*s);
  throw InputError("surface of a half-space or a mesh: there is none to make");
}

Mesh extruded(std::span<const std::array<double, 2>> profile, double half_width) {
  Growing solid;
  const auto count = static_cast<std::uint32_t>(profile.size());
  for (const double y : {-half_width, half_width}) {
    for (const auto& [x, z] : profile)
      solid.add({x, y, z});
  }
  std::vector<std::uint32_t> front, back;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    solid.add_polygon(std::array{i, i + count, next + count, next});
    front.push_back(i);
    back.insert(back.begin(), i + count);
  }
  solid.add_polygon(front);
  // The fan begins at the same corner as in front, so that it covers here what it covers there.
  std::rotate(back.begin(), back.end() - 1, back.end());
  solid.add_polygon(back);
  return solid.mesh();
}

}  // namespace graze::samples
