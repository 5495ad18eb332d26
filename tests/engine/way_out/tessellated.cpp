#include "tests/engine/way_out/tessellated.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "tests/engine/world/random_shapes.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;

/// Vertices by their places on a grid, each once.
class GridMesh {
 public:
  std::uint32_t vertex(const Cube& place, const Vector3d& point) {
    const auto [at, is_new] = numbers_.try_emplace(place, vertices_.size());
    if (is_new) vertices_.push_back(point);
    return static_cast<std::uint32_t>(at->second);
  }
  void add_square(const std::array<std::uint32_t, 4>& corners, bool cuts_other_way) {
    const auto [a, b, c, d] = corners;
    if (cuts_other_way) {
      triangles_.push_back({a, b, d}), triangles_.push_back({b, c, d});
    } else {
      triangles_.push_back({a, b, c}), triangles_.push_back({a, c, d});
    }
  }
  Mesh mesh() const { return {vertices_, std::span<const TriangleIndices>(triangles_)}; }

 private:
  std::map<Cube, std::size_t> numbers_;
  std::vector<Vector3d> vertices_;
  std::vector<TriangleIndices> triangles_;
};

}  // namespace

Mesh tessellated_box(const Vector3d& half_extents, int cells) {
  GridMesh grid;
  for (int k = 0; k < 3; ++k) {
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    for (const int side : {0, cells}) {
      const auto corner = [&](int i, int j) {
        Cube place{};
        place[static_cast<std::size_t>(k)] = side;
        place[static_cast<std::size_t>(u)] = i, place[static_cast<std::size_t>(v)] = j;
        Vector3d point;
        for (int axis = 0; axis < 3; ++axis)
          point[axis] =
              half_extents[axis] * (2.0 * place[static_cast<std::size_t>(axis)] / cells - 1);
        return grid.vertex(place, point);
      };
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          if (side == 0) {
            grid.add_square(
                {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)}, false);
          } else {
            grid.add_square(
                {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}, false);
          }
        }
      }
    }
  }
  return grid.mesh();
}

Mesh turned_profile(std::span<const ProfilePoint> profile, int sectors,
                    const std::array<double, 2>& stretch) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  std::vector<std::vector<std::uint32_t>> rings;
  for (const auto& [radius, height] : profile) {
    std::vector<std::uint32_t> ring;
    for (int i = 0; i < sectors; ++i) {
      if (radius == 0 && i > 0) {
        ring.push_back(ring[0]);
        continue;
      }
      ring.push_back(static_cast<std::uint32_t>(vertices.size()));
      const double angle = 2 * std::numbers::pi * i / sectors;
      vertices.push_back(
          {stretch[0] * radius * std::cos(angle), stretch[1] * radius * std::sin(angle), height});
    }
    rings.push_back(ring);
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      const std::size_t j = (i + 1) % rings[r].size();
      const std::uint32_t a = rings[r][i], b = rings[r][j];
      const std::uint32_t c = rings[r + 1][j], d = rings[r + 1][i];
      if (a != b) triangles.push_back({a, b, c});
      if (c != d) triangles.push_back({a, c, d});
    }
  }
  return {vertices, std::span<const TriangleIndices>(triangles)};
}

Mesh surface_of_cubes(std::span<const Cube> cubes, double edge, int cells, RandomSource& source) {
  const std::set<Cube> all(cubes.begin(), cubes.end());
  GridMesh grid;
  for (const Cube& cube : all) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      for (const int side : {0, 1}) {
        Cube beyond = cube;
        beyond[k] += side == 0 ? -1 : 1;
        if (all.contains(beyond)) continue;
        const auto corner = [&](int i, int j) {
          Cube place{};
          place[k] = (cube[k] + side) * cells;
          place[u] = cube[u] * cells + i, place[v] = cube[v] * cells + j;
          return grid.vertex(place, Vector3d(place[0], place[1], place[2]) * (edge / cells));
        };
        for (int i = 0; i < cells; ++i) {
          for (int j = 0; j < cells; ++j) {
            const std::uint32_t a = corner(i, j), b = corner(i + 1, j);
            const std::uint32_t c = corner(i + 1, j + 1), d = corner(i, j + 1);
            const bool cuts_other_way = source.uniform(0, 1) < 0.5;
            if (side == 1) {
              grid.add_square({a, b, c, d}, cuts_other_way);
            } else {
              grid.add_square({a, d, c, b}, cuts_other_way);
            }
          }
        }
      }
    }
  }
  return grid.mesh();
}

Mesh convex_mesh(ConvexMeshKind kind, int fineness, RandomSource& source) {
  const double x = source.uniform(0.4, 1), y = source.uniform(0.4, 1), z = source.uniform(0.4, 1);
  const int steps = 1 << fineness;
  std::vector<ProfilePoint> profile;
  switch (kind) {
    case ConvexMeshKind::Box:
      return tessellated_box({x, y, z}, steps);
    case ConvexMeshKind::Ball: {
      const int rings = 4 + 2 * steps;
      for (int i = 0; i <= rings; ++i) {
        const double angle = std::numbers::pi * i / rings;
        const bool is_pole = i == 0 || i == rings;
        profile.push_back({is_pole ? 0 : std::sin(angle), -z * std::cos(angle)});
      }
      return turned_profile(profile, 2 * rings, {x, y});
    }
    case ConvexMeshKind::Prism:
      profile = {{0, -z}, {1, -z}, {1, z}, {0, z}};
      return turned_profile(profile, 6 + 4 * steps, {x, x});
    case ConvexMeshKind::Cone:
      profile = {{0, -z}, {1, -z}, {0, z}};
      return turned_profile(profile, 6 + 4 * steps, {x, x});
  }
  return tessellated_box({x, y, z}, 1);
}

double reach_of(const Shape& shape, const Pose& pose, const Eigen::Vector3d& way) {
  const Mesh* mesh = shape.as<Mesh>();
  if (mesh == nullptr) return reach_along(shape, pose, way);
  double most = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex : mesh->vertices())
    most = std::max(most, way.dot(pose * vertex));
  return most;
}

}  // namespace graze::tests
