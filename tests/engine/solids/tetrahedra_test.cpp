// Open interiors of tetrahedra on a small lattice: no plane of a face, nor one along an edge of
// each, may part them. In whole numbers.

#include <graze/engine/mesh/pair.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Vector = std::array<std::int64_t, 3>;
using Corners = std::array<Vector, 4>;

Vector minus(const Vector& p, const Vector& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Vector cross(const Vector& p, const Vector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

std::int64_t dot(const Vector& p, const Vector& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

std::int64_t volume(const Corners& t) {
  return dot(cross(minus(t[1], t[0]), minus(t[2], t[0])), minus(t[3], t[0]));
}

bool does_part(const Vector& direction, const Corners& s, const Corners& t) {
  if (direction == Vector{0, 0, 0}) return false;
  std::array<std::array<std::int64_t, 4>, 2> along;
  for (std::size_t i = 0; i < 4; ++i)
    along[0][i] = dot(direction, s[i]), along[1][i] = dot(direction, t[i]);
  const auto [low_s, high_s] = std::minmax_element(along[0].begin(), along[0].end());
  const auto [low_t, high_t] = std::minmax_element(along[1].begin(), along[1].end());
  return *high_s <= *low_t || *high_t <= *low_s;
}

std::vector<Vector> edges_of(const Corners& t) {
  std::vector<Vector> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j)
      edges.push_back(minus(t[j], t[i]));
  }
  return edges;
}

/// Of tetrahedra with volume.
bool are_open_sets_apart(const Corners& s, const Corners& t) {
  for (const Corners& each : {s, t}) {
    for (const Vector& p : edges_of(each)) {
      for (const Vector& q : edges_of(each)) {
        if (does_part(cross(p, q), s, t)) return true;
      }
    }
  }
  for (const Vector& p : edges_of(s)) {
    for (const Vector& q : edges_of(t)) {
      if (does_part(cross(p, q), s, t)) return true;
    }
  }
  return false;
}

Corners random_corners(int size, const Eigen::Vector3d& offset, RandomSource& source) {
  Corners corners;
  do {
    for (Vector& corner : corners) {
      const Eigen::Vector3d p = source.lattice_point(0, size) + offset;
      corner = {static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y()),
                static_cast<std::int64_t>(p.z())};
    }
  } while (volume(corners) == 0);
  return corners;
}

Mesh tetrahedron(const Corners& corners, double unit) {
  std::vector<Eigen::Vector3d> vertices;
  for (const Vector& p : corners) {
    vertices.push_back(unit * Eigen::Vector3d(static_cast<double>(p[0]), static_cast<double>(p[1]),
                                              static_cast<double>(p[2])));
  }
  const std::array<TriangleIndices, 4> triangles{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  return {vertices, triangles};
}

TEST(Interiors, OfTetrahedraOnALattice) {
  RandomSource source(45);
  int met = 0, touching = 0, apart = 0;
  for (int n = 0; n < 2500; ++n) {
    const int size = 2 + n % 3;
    const Eigen::Vector3d offset =
        n % 2 == 0 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(source.lattice_point(-2, 2));
    const Corners s = random_corners(size, {0, 0, 0}, source);
    const Corners t = random_corners(size, offset, source);
    const double unit = n % 5 == 0 ? 0x1p-300 : n % 5 == 1 ? 0x1p+300 : 1;
    const Mesh a = tetrahedron(s, unit), b = tetrahedron(t, unit);
    const bool is_expected = !are_open_sets_apart(s, t);
    EXPECT_EQ(interiors_intersect(a, b), is_expected) << n;
    EXPECT_EQ(interiors_intersect(b, a), is_expected) << n;
    met += is_expected;
    (intersects(a, b) ? touching : apart) += !is_expected;
  }
  EXPECT_GT(met, 600);
  EXPECT_GT(touching, 200);
  EXPECT_GT(apart, 100);
}

}  // namespace
}  // namespace graze
