#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/separating_translation.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "tests/narrowphase/derived/rational_triangles.h"
#include "tests/shapes/random_meshes.h"

// What find_contacts() says of two tetrahedra, against rational arithmetic: convex shapes, so that
// what lies inside is behind four planes, and the last contact along a direction is a minimum over
// the facets of the difference of the two.

namespace graze {
namespace {

using oracle::exactly;
using Point = oracle::RationalPoint;

Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
mpq_class dot(const Point& p, const Point& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
mpq_class length_1(const Point& p) {
  return abs(p[0]) + abs(p[1]) + abs(p[2]);
}

/// With faces that turn counter-clockwise as seen from outside.
Mesh tetrahedron(RandomSource& source, double scale, const Eigen::Vector3d& offset) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 4; ++i)
    corners.emplace_back(scale * source.vector(-1, 1) + offset);
  const auto edge = [&](std::size_t i) -> Eigen::Vector3d { return corners[i] - corners[0]; };
  if (edge(1).dot(edge(2).cross(edge(3))) < 0) std::swap(corners[2], corners[3]);
  const std::vector<TriangleIndices> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return Mesh(corners, faces);
}

/// A placed tetrahedron.
struct Solid {
  explicit Solid(const PlacedMesh& placed) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      faces.push_back(place(placed.pose, placed.mesh.triangle(i)));
      const Point a = exactly(faces[i].a);
      normals.push_back(cross(minus(exactly(faces[i].b), a), minus(exactly(faces[i].c), a)));
      for (const Eigen::Vector3d& p : {faces[i].a, faces[i].b, faces[i].c})
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    corners = {exactly(faces[0].a), exactly(faces[0].b), exactly(faces[0].c), exactly(faces[1].c)};
  }

  bool holds(const Point& p) const {
    for (std::size_t i = 0; i < 4; ++i) {
      if (dot(normals[i], minus(p, exactly(faces[i].a))) > 0) return false;
    }
    return true;
  }

  std::vector<Triangle> faces;
  std::vector<Point> normals;  // outward
  std::vector<Point> corners;
  double largest = 0;
};

mpq_class furthest(const std::vector<Point>& points, const Point& direction) {
  mpq_class result = dot(points[0], direction);
  for (const Point& p : points)
    result = std::max(result, dot(p, direction));
  return result;
}

Point negated(const Point& p) {
  return {-p[0], -p[1], -p[2]};
}

/// The largest s for which A and B + s n share a point.
mpq_class last_contact(const Solid& a, const Solid& b, const Point& n) {
  std::vector<Point> facets;
  for (std::size_t i = 0; i < 4; ++i) {
    facets.push_back(a.normals[i]);
    facets.push_back(negated(b.normals[i]));
  }
  for (int i = 0; i < 36; ++i) {
    static constexpr std::size_t kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    const auto& [p, q] = kEdges[i / 6];
    const auto& [r, s] = kEdges[i % 6];
    facets.push_back(cross(minus(a.corners[q], a.corners[p]), minus(b.corners[s], b.corners[r])));
    facets.push_back(negated(facets.back()));
  }
  mpq_class least = -1;
  for (const Point& m : facets) {
    const mpq_class pace = dot(m, n);
    if (pace <= 0) continue;
    const mpq_class s = (furthest(a.corners, m) + furthest(b.corners, negated(m))) / pace;
    if (least < 0 || s < least) least = s;
  }
  return least;
}

/// The loops in which two tetrahedra meet, if all of it is in general position; their area and
/// length in all.
struct Loops {
  Loops(const Solid& a, const Solid& b) {
    for (std::size_t i = 0; i < 16; ++i) {
      const std::vector<Point> found =
          oracle::rational_intersection(a.faces[i / 4], b.faces[i % 4]);
      if (found.empty()) continue;
      is_generic &= found.size() == 2;
      corners.insert(corners.end(), found.begin(), found.end());
      if (found.size() != 2) continue;
      segments.push_back({found[0], found[1]});
      const Point along = minus(found[1], found[0]);
      const bool is_forward = dot(along, cross(a.normals[i / 4], b.normals[i % 4])) > 0;
      const Point twice = cross(found[0], found[1]);
      for (std::size_t k = 0; k < 3; ++k)
        area[k] += is_forward ? twice[k] : -twice[k];
      perimeter += length_1(along);
    }
  }

  /// Segments that share corners are one loop.
  std::size_t count() const {
    std::vector<std::size_t> loop_of(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
      loop_of[i] = i;
      for (std::size_t j = 0; j < i; ++j) {
        const auto& [p, q] = segments[j];
        const bool is_joined = segments[i][0] == p || segments[i][0] == q || segments[i][1] == p ||
                               segments[i][1] == q;
        const std::size_t from = loop_of[j], to = loop_of[i];
        if (is_joined) std::replace(loop_of.begin(), loop_of.end(), from, to);
      }
    }
    return std::set<std::size_t>(loop_of.begin(), loop_of.end()).size();
  }

  bool is_generic = true;
  std::vector<Point> corners;
  std::vector<std::array<Point, 2>> segments;
  Point area;  // twice
  mpq_class perimeter;
};

bool is_one_of(const Eigen::Vector3d& found, const std::vector<Point>& exact,
               const mpq_class& reach) {
  return std::any_of(exact.begin(), exact.end(),
                     [&](const Point& p) { return oracle::are_within(p, found, reach); });
}

std::vector<Point> with_inner(const Loops& loop, const Solid& solid, const Solid& other) {
  std::vector<Point> points = loop.corners;
  for (const Point& p : solid.corners) {
    if (other.holds(p)) points.push_back(p);
  }
  return points;
}

void expect_points(const MeshContacts& found, const Loops& loop, const std::vector<Point>& part_a,
                   const std::vector<Point>& part_b, const mpq_class& ulp) {
  for (const Eigen::Vector3d& point : found.points)
    EXPECT_TRUE(is_one_of(point, loop.corners, 2 * ulp));
  for (const Point& exact : loop.corners) {
    EXPECT_TRUE(std::any_of(found.points.begin(), found.points.end(), [&](const auto& point) {
      return oracle::are_within(exact, point, 2 * ulp);
    }));
  }
  const MeshContact& contact = found[0];
  EXPECT_TRUE(is_one_of(contact.point_a, part_a, 2 * ulp));
  EXPECT_TRUE(is_one_of(contact.point_b, part_b, 2 * ulp));
  const Point a = exactly(contact.point_a), b = exactly(contact.point_b);
  const Point middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  EXPECT_TRUE(oracle::are_within(middle, contact.point, ulp));
}

/// Of unit length, and the direction of the exact area vector: corners that are off by 2 ulp turn
/// it by no more than that times the perimeter, and the products of coordinates round likewise.
void expect_normal(const Point& normal, const Loops& loop, const mpq_class& ulp) {
  EXPECT_TRUE(abs(dot(normal, normal) - 1) <= 0x1p-50);
  const Point off = cross(normal, loop.area);
  EXPECT_TRUE(dot(off, off) <= 64 * 64 * ulp * ulp * loop.perimeter * loop.perimeter);
  EXPECT_TRUE(dot(normal, loop.area) > 0);
}

TEST(Law7Contacts, TetrahedraAgreeWithRationalArithmetic) {
  RandomSource source(77);
  int contacts = 0;
  for (int n = 0; n < 160; ++n) {
    const double scale = n % 4 == 1 ? 1e-9 : n % 4 == 2 ? 1e6 : 1;
    const Eigen::Vector3d offset = n % 4 == 3 ? source.vector(-1e6, 1e6) : source.vector(-1, 1);
    const Mesh mesh_a = tetrahedron(source, scale, scale * offset);
    const Mesh mesh_b = tetrahedron(source, scale, Eigen::Vector3d::Zero());
    Pose pose = tests::random_pose(scale, source);
    pose.translation() = scale * offset + 0.6 * scale * source.vector(-1, 1);
    const PlacedMesh a{mesh_a}, b{mesh_b, pose};
    const Solid solid_a(a), solid_b(b);
    const Loops loop(solid_a, solid_b);
    const MeshContacts found = find_contacts(a, b);
    ASSERT_EQ(found.empty(), loop.corners.empty()) << n;
    if (found.empty() || !loop.is_generic) continue;
    SCOPED_TRACE(n);
    ASSERT_EQ(found.size(), loop.count());
    if (found.size() > 1) continue;  // an edge of one goes through the other
    ++contacts;
    const double largest = std::max(solid_a.largest, solid_b.largest);
    const mpq_class ulp = std::ldexp(1, std::ilogb(largest) - 52);
    const std::vector<Point> part_a = with_inner(loop, solid_a, solid_b);
    const std::vector<Point> part_b = with_inner(loop, solid_b, solid_a);
    const Point normal = exactly(found[0].normal);
    expect_points(found, loop, part_a, part_b, ulp);
    expect_normal(normal, loop, ulp);
    const mpq_class width = furthest(part_a, normal) + furthest(part_b, negated(normal));
    const mpq_class depth = found[0].depth;
    const mpq_class last = last_contact(solid_a, solid_b, normal);
    const mpq_class separated = separating_translation(a, b, found[0].normal).distance;
    EXPECT_TRUE(depth >= std::min(width, last) - 16 * ulp);
    EXPECT_TRUE(depth <= width + 16 * ulp);
    EXPECT_TRUE(depth <= separated + 16 * ulp);
    EXPECT_TRUE(separated >= last);
  }
  EXPECT_GT(contacts, 30);
}

}  // namespace
}  // namespace graze
