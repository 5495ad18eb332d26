#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/engine/contacts/placed_pairs.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::shifted;

Pose turned(const Eigen::Vector3d& axis, double angle, const Eigen::Vector3d& shift) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(angle, axis.normalized()).matrix();
  pose.translation() = shift;
  return pose;
}

double largest_coordinate(const Triangle& t) {
  return std::max(
      {t.a.cwiseAbs().maxCoeff(), t.b.cwiseAbs().maxCoeff(), t.c.cwiseAbs().maxCoeff()});
}

double ulp(double value) {
  return std::nextafter(value, INFINITY) - value;
}

/// Law 7: each of the points is near one of those.
void expect_near(const std::vector<Eigen::Vector3d>& points, const TriangleIntersection& expected,
                 double tolerance) {
  for (const Eigen::Vector3d& p : points) {
    double nearest = INFINITY;
    for (const Eigen::Vector3d& q : expected)
      nearest = std::min(nearest, (p - q).cwiseAbs().maxCoeff());
    EXPECT_LE(nearest, tolerance);
  }
}

void expect_all_found(const TriangleIntersection& expected, const MeshIntersection& found,
                      double tolerance) {
  for (const Eigen::Vector3d& q : expected) {
    EXPECT_TRUE(std::any_of(found.points.begin(), found.points.end(), [&](const auto& p) {
      return (p.position - q).cwiseAbs().maxCoeff() <= tolerance;
    }));
  }
}

/// Every pair of triangles that meet, and no other, is named, by what intersection() says of it.
void expect_brute_force(const PlacedMesh& a, const PlacedMesh& b, const MeshIntersection& found) {
  std::map<TrianglePair, std::set<std::uint32_t>> named;
  for (const IntersectionSegment& s : found.segments) {
    for (const TrianglePair& pair : found.pairs_of(s))
      named[pair].insert({s.from, s.to});
  }
  for (const IntersectionPolygon& polygon : found.polygons) {
    for (const TrianglePair& pair : found.pairs_of(polygon))
      named[pair].insert(polygon.corners.begin(), polygon.corners.begin() + polygon.corner_count);
  }
  for (const TouchingPoint& touching : found.touching_points) {
    for (const TrianglePair& pair : found.pairs_of(touching))
      named[pair].insert(touching.point);
  }
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    const Triangle s = place(a.pose, a.mesh.triangle(i));
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      const Triangle t = place(b.pose, b.mesh.triangle(j));
      const TriangleIntersection expected = intersection(s, t);
      const auto place_in_list = named.find({i, j});
      if (place_in_list == named.end()) {
        // A point of it may be the end of a segment, and a segment the edge of a polygon.
        EXPECT_NE(expected.kind, IntersectionKind::Polygon) << i << " " << j;
        expect_all_found(expected, found,
                         4 * ulp(std::max(largest_coordinate(s), largest_coordinate(t))));
        continue;
      }
      EXPECT_NE(expected.kind, IntersectionKind::None);
      std::vector<Eigen::Vector3d> points;
      for (std::uint32_t point : place_in_list->second)
        points.push_back(found.points[point].position);
      if (expected.kind == IntersectionKind::Polygon) {
        EXPECT_EQ(points.size(), static_cast<std::size_t>(expected.count));
      }
      const double size = std::max(largest_coordinate(s), largest_coordinate(t));
      if (named.at({i, j}).size() == static_cast<std::size_t>(expected.count))
        expect_near(points, expected, 4 * ulp(size));
    }
  }
}

void expect_same(const MeshIntersection& one, const MeshIntersection& other) {
  ASSERT_EQ(one.points.size(), other.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i)
    EXPECT_EQ(one.points[i].position, other.points[i].position);
  ASSERT_EQ(one.segments.size(), other.segments.size());
  for (std::size_t i = 0; i < one.segments.size(); ++i) {
    EXPECT_EQ(one.segments[i].from, other.segments[i].from);
    EXPECT_EQ(one.segments[i].to, other.segments[i].to);
    EXPECT_EQ(one.segments[i].pair_count, other.segments[i].pair_count);
  }
  EXPECT_EQ(one.curves.size(), other.curves.size());
  ASSERT_EQ(one.polygons.size(), other.polygons.size());
  for (std::size_t i = 0; i < one.polygons.size(); ++i)
    EXPECT_EQ(one.polygons[i].corners, other.polygons[i].corners);
  EXPECT_EQ(one.patches.size(), other.patches.size());
  EXPECT_EQ(one.touching_points.size(), other.touching_points.size());
}

/// What holds of every intersection.
MeshIntersection expect_sound(const PlacedMesh& a, const PlacedMesh& b) {
  const MeshIntersection found = find_intersection(a, b);
  EXPECT_EQ(found.empty(), !intersects(a, b));
  std::vector<int> uses(found.points.size());
  std::size_t listed = 0;
  for (const IntersectionCurve& curve : found.curves) {
    const auto segments = found.segments_of(curve);
    listed += segments.size();
    for (std::size_t i = 0; i + 1 < segments.size(); ++i)
      EXPECT_EQ(segments[i].to, segments[i + 1].from);
    EXPECT_EQ(curve.is_closed, segments.front().from == segments.back().to);
  }
  EXPECT_EQ(listed, found.segments.size());
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const IntersectionSegment& s : found.segments) {
    ++uses[s.from];
    ++uses[s.to];
    EXPECT_NE(s.from, s.to);
    EXPECT_TRUE(edges.insert(std::minmax(s.from, s.to)).second) << "a segment twice";
  }
  for (const IntersectionPolygon& polygon : found.polygons) {
    for (std::uint32_t i = 0; i < polygon.corner_count; ++i)
      ++uses[polygon.corners[i]];
  }
  for (const TouchingPoint& touching : found.touching_points) {
    EXPECT_EQ(uses[touching.point], 0);
    ++uses[touching.point];
  }
  for (int count : uses)
    EXPECT_GT(count, 0) << "a point of nothing";
  expect_same(found, find_intersection(b, a));
  for (const PairVolume volume : kPairVolumes)
    expect_same(found, find_intersection(a, b, {.volume = volume}));
  return found;
}

/// Closed meshes in general position.
std::size_t expect_loops(const PlacedMesh& a, const PlacedMesh& b) {
  const MeshIntersection found = expect_sound(a, b);
  EXPECT_EQ(found.points.size(), found.segments.size());
  EXPECT_TRUE(found.polygons.empty());
  EXPECT_TRUE(found.touching_points.empty());
  std::vector<int> uses(found.points.size());
  for (const IntersectionSegment& s : found.segments) {
    ++uses[s.from];
    ++uses[s.to];
    EXPECT_EQ(s.pair_count, 1u);
  }
  for (int count : uses)
    EXPECT_EQ(count, 2);
  for (const IntersectionPoint& p : found.points) {
    EXPECT_TRUE((p.feature_a == Feature::Edge && p.feature_b == Feature::Face) ||
                (p.feature_a == Feature::Face && p.feature_b == Feature::Edge));
  }
  for (const IntersectionCurve& curve : found.curves) {
    EXPECT_TRUE(curve.is_closed);
    EXPECT_GE(curve.segment_count, 3u);
  }
  return found.curves.size();
}

TEST(MeshIntersection, SpheresAndToriMeetInAsManyLoopsAsTheyShould) {
  const Mesh sphere = tests::make_sphere(1, 21, 30);
  const Mesh torus = tests::make_torus(1, 0.3, 40, 20);
  const Mesh plate = tests::make_box({3, 3, 0.0123});
  EXPECT_EQ(expect_loops({sphere}, {sphere, shifted(0.31, 0.27, 0.17)}), 1u);
  EXPECT_EQ(expect_loops({sphere}, {plate, turned({1, 2, 3}, 0.3, {0.1, 0, 0.2})}), 2u);
  EXPECT_EQ(expect_loops({torus}, {plate, turned({1, 0.1, 0}, 0.01, {0, 0, 0.0321})}), 4u);
  EXPECT_EQ(expect_loops({torus}, {plate, turned({1, 0.1, 0}, 1.5, {0.01, 0.02, 0})}), 4u);
  // Linked like a chain and pulled together: the tubes cross once.
  EXPECT_EQ(expect_loops({torus}, {torus, turned({1, 0.02, 0.01}, 1.57, {1.523, 0.01, 0.02})}), 1u);
  EXPECT_EQ(expect_loops({torus}, {sphere, turned({1, 2, 3}, 1, {10, 0, 0})}), 0u);
}

class IntersectionOfParts : public testing::TestWithParam<const char*> {};

TEST_P(IntersectionOfParts, IsClosedLoops) {
  const tests::BundledPair pair(GetParam());
  for (std::size_t i = 0; i < pair.poses.size(); i += 9)
    EXPECT_GT(expect_loops({pair.mesh_a}, {pair.mesh_b, pair.poses[i]}), 0u);
}

INSTANTIATE_TEST_SUITE_P(Bundled, IntersectionOfParts,
                         testing::Values("rock-rock.touch", "rock-rock.deep", "link-link.touch",
                                         "bolt-nut.touch"));

TEST(Law9Intersection, SoupsAgreeWithTheirTriangles) {
  RandomSource source(1);
  std::size_t segments = 0, polygons = 0, touching = 0;
  for (int n = 0; n < 120; ++n) {
    const bool is_lattice = n % 2 == 0;
    const Mesh a = is_lattice ? tests::lattice_soup(24, n % 4 == 0 ? 1 : 2, source)
                              : tests::random_soup({.count = 30}, source);
    const Mesh b = is_lattice ? tests::lattice_soup(24, n % 4 == 0 ? 1 : 2, source)
                              : tests::random_soup({.count = 30}, source);
    const MeshIntersection found = expect_sound({a}, {b});
    expect_brute_force({a}, {b}, found);
    segments += found.segments.size();
    polygons += found.polygons.size();
    touching += found.touching_points.size();
  }
  EXPECT_GT(segments, 2000u);
  EXPECT_GT(polygons, 100u);
  EXPECT_GT(touching, 10u);
}

double area_of(const MeshIntersection& found, const IntersectionPolygon& polygon) {
  Eigen::Vector3d sum(0, 0, 0);
  const Eigen::Vector3d& origin = found.points[polygon.corners[0]].position;
  for (std::uint32_t i = 1; i + 1 < polygon.corner_count; ++i) {
    sum += (found.points[polygon.corners[i]].position - origin)
               .cross(found.points[polygon.corners[i + 1]].position - origin);
  }
  return 0.5 * sum.norm();
}

double area_of(const MeshIntersection& found) {
  double area = 0;
  for (const IntersectionPolygon& polygon : found.polygons)
    area += area_of(found, polygon);
  return area;
}

TEST(MeshIntersection, ABoxRestingOnABoxIsOnePatch) {
  const Mesh table = tests::make_box({4, 4, 1});
  const Mesh box = tests::make_box({1, 1, 1});
  for (const double shift : {0.0, 0.25, 1.0, 3.0, 4.0}) {
    const MeshIntersection found = expect_sound({table}, {box, shifted(shift, 0.5, 2)});
    EXPECT_EQ(found.patches.size(), 1u);
    EXPECT_EQ(found.curves.size(), 0u);
    EXPECT_EQ(found.touching_points.size(), 0u);
    EXPECT_DOUBLE_EQ(area_of(found), shift == 4 ? 2.0 : 4.0);
  }
  const MeshIntersection edge = expect_sound({table}, {box, shifted(5, 0, 2)});
  EXPECT_EQ(edge.patches.size(), 0u);
  ASSERT_EQ(edge.curves.size(), 1u) << "edge on edge";
  EXPECT_FALSE(edge.curves[0].is_closed);
  const MeshIntersection corner = expect_sound({table}, {box, shifted(5, 5, 2)});
  EXPECT_EQ(corner.curves.size(), 0u);
  ASSERT_EQ(corner.touching_points.size(), 1u);
  EXPECT_EQ(corner.points[0].feature_a, Feature::Vertex);
  EXPECT_EQ(corner.points[0].feature_b, Feature::Vertex);
  EXPECT_EQ(corner.points[0].position, Eigen::Vector3d(4, 4, 1));
}

TEST(MeshIntersection, AlignedBoxesShareLoopsThroughTheirDiagonals) {
  const Mesh table = tests::make_box({4, 4, 1});
  const Mesh box = tests::make_box({1, 1, 1});
  // Edges of the box cross the diagonal of the table's top.
  const MeshIntersection found = expect_sound({table}, {box, shifted(0, 0, 1.5)});
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves[0].is_closed);
  EXPECT_TRUE(found.polygons.empty());
  const MeshIntersection self = expect_sound({box}, {box});
  EXPECT_EQ(self.patches.size(), 1u);
  EXPECT_EQ(self.curves.size(), 0u);
  EXPECT_DOUBLE_EQ(area_of(self), 24);
}

TEST(MeshIntersection, TouchesAreWhatTheyAre) {
  const std::vector<Eigen::Vector3d> tip = {{0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}};
  const std::vector<TriangleIndices> sides = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
  const Mesh cone(tip, sides);
  const Mesh table = tests::make_box({4, 4, 1});
  const MeshIntersection touch = expect_sound({table}, {cone, shifted(0.5, 0.25, 1)});
  ASSERT_EQ(touch.touching_points.size(), 1u);
  EXPECT_EQ(touch.points[0].feature_a, Feature::Face);
  EXPECT_EQ(touch.points[0].feature_b, Feature::Vertex);
  EXPECT_EQ(touch.pairs_of(touch.touching_points[0]).size(), 3u);

  const std::vector<Eigen::Vector3d> roof = {{-1, 0, 0}, {1, 0, 0},   {-1, 1, 1},
                                             {1, 1, 1},  {-1, -1, 1}, {1, -1, 1}};
  const std::vector<TriangleIndices> slopes = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}};
  const Mesh keel(roof, slopes);
  const MeshIntersection line = expect_sound({table}, {keel, shifted(0.5, 0.25, 1)});
  EXPECT_EQ(line.curves.size(), 1u);
  EXPECT_FALSE(line.curves[0].is_closed);
  const Pose upside = turned({1, 0, 0}, M_PI, {0, 0, 0});
  Pose across = Pose::Identity();
  across.linear() << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  const MeshIntersection crossing = expect_sound({keel, across}, {keel, shifted(0.125, 0.25, 0)});
  ASSERT_EQ(crossing.touching_points.size(), 1u);
  EXPECT_EQ(crossing.points[0].feature_a, Feature::Edge);
  EXPECT_EQ(crossing.points[0].feature_b, Feature::Edge);
  EXPECT_EQ(crossing.pairs_of(crossing.touching_points[0]).size(), 4u);
  EXPECT_EQ(expect_sound({keel, upside}, {keel, shifted(0, 0, 0.5)}).empty(), true);
}

TEST(MeshIntersection, OpenMeshesEndTheirCurves) {
  const Mesh sphere = tests::make_sphere(1, 21, 30);
  const Mesh sheet = tests::make_row(1);
  const MeshIntersection found = expect_sound({sphere}, {sheet, shifted(0.711, 0.123, 0.0456)});
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_FALSE(found.curves[0].is_closed);
}

/// A degenerate triangle in an edge: its long side is two edges of its neighbours.
TEST(MeshIntersection, TrianglesWithoutAreaBreakNoLoop) {
  const Mesh box = tests::make_box({1, 1, 1});
  std::vector<Eigen::Vector3d> vertices(box.vertices().begin(), box.vertices().end());
  std::vector<TriangleIndices> triangles(box.triangles().begin(), box.triangles().end());
  // One triangle is split at the middle of an edge; the other side of the edge keeps it whole.
  const TriangleIndices whole = triangles[0];
  const auto middle = static_cast<std::uint32_t>(vertices.size());
  vertices.push_back(0.5 * (vertices[whole[0]] + vertices[whole[1]]));
  triangles[0] = {whole[0], middle, whole[2]};
  triangles.push_back({middle, whole[1], whole[2]});
  triangles.push_back({whole[0], whole[1], middle});
  const Mesh mended(vertices, triangles);
  ASSERT_TRUE(mended.topology().is_closed);
  ASSERT_EQ(mended.topology().degenerate_triangles, 1u);
  RandomSource source(5);
  for (int n = 0; n < 40; ++n) {
    const Mesh other = tests::make_sphere(0.6, 9, 12);
    const Eigen::Vector3d shift = 0.9 * vertices[middle] + source.vector(-0.2, 0.2);
    const Pose pose = turned(source.vector(-1, 1), 1, shift);
    const MeshIntersection found = expect_sound({mended}, {other, pose});
    for (const IntersectionCurve& curve : found.curves) {
      for (const IntersectionSegment& s : found.segments_of(curve))
        EXPECT_GE(s.pair_count, 1u);
    }
    EXPECT_GT(found.segments.size(), 0u);
  }
}

TEST(MeshIntersection, DuplicatesAreNamedAndNotDoubled) {
  const Mesh sphere = tests::make_sphere(1, 9, 12);
  std::vector<TriangleIndices> twice(sphere.triangles().begin(), sphere.triangles().end());
  twice.insert(twice.end(), sphere.triangles().begin(), sphere.triangles().end());
  const Mesh doubled(sphere.vertices(), twice);
  const Pose pose = turned({1, 2, 3}, 0.5, {0.7, 0.1, 0.2});
  const MeshIntersection once = expect_sound({sphere}, {sphere, pose});
  const MeshIntersection both = expect_sound({doubled}, {sphere, pose});
  EXPECT_EQ(both.points.size(), once.points.size());
  EXPECT_EQ(both.curves.size(), once.curves.size());
  for (const IntersectionSegment& s : both.segments)
    EXPECT_EQ(s.pair_count, 2u);
}

TEST(MeshIntersection, ScalesAndOffsets) {
  const Mesh sphere = tests::make_sphere(1, 9, 12);
  const Pose pose = turned({1, 2, 3}, 0.5, {0.7, 0.1, 0.2});
  const MeshIntersection once = find_intersection({sphere}, {sphere, pose});
  for (const double scale : {0x1p-500, 0x1p-40, 0x1p500}) {
    const Mesh scaled = tests::mapped(sphere, scale, {0, 0, 0});
    Pose there = pose;
    there.translation() *= scale;
    const MeshIntersection found = expect_sound({scaled}, {scaled, there});
    ASSERT_EQ(found.points.size(), once.points.size());
    for (std::size_t i = 0; i < once.points.size(); ++i)
      EXPECT_EQ(found.points[i].position, once.points[i].position * scale);
  }
  for (const double offset : {1e9, 1e15}) {
    Pose here = Pose::Identity();
    here.translation().setConstant(offset);
    Pose there = pose;
    there.translation() += here.translation();
    expect_sound({sphere, here}, {sphere, there});
  }
}

TEST(MeshIntersection, LatticeSolidsLeaveNoLooseEnds) {
  RandomSource source(11);
  for (int n = 0; n < 60; ++n) {
    const Mesh a = tests::lattice_tetrahedra(3, 3, source);
    const Mesh b = tests::lattice_tetrahedra(3, 3, source);
    const MeshIntersection found = expect_sound({a}, {b});
    expect_brute_force({a}, {b}, found);
  }
}

}  // namespace
}  // namespace graze
