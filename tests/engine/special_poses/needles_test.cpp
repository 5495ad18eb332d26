// Hulls that are needles, wedges and blades, triangles that are, and what lies beside an axis or an
// end by next to nothing: where contacts stand, and which way they lead.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/engine/special_poses/pair_laws.h"
#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/special_poses/special_pairs.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/engine/world/surface_distance.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::PlacedPair;
using tests::Surface;

double thin(RandomSource& source) {
  return std::pow(10.0, source.uniform(-8, -2));
}

/// A prism or a pyramid along z over a polygon of two widths, or a wedge with a second edge that is
/// narrower by far than the first.
ConvexHull needle(std::size_t kind, RandomSource& source) {
  std::vector<Vector3d> corners;
  const double width = thin(source), height = thin(source);
  const int sides = 3 + static_cast<int>(kind / 3 % 4);
  for (int i = 0; i < sides && kind % 3 != 2; ++i) {
    const double angle = 2 * M_PI * i / sides;
    corners.emplace_back(width * std::cos(angle), height * std::sin(angle), -1);
    if (kind % 3 == 0) corners.emplace_back(width * std::cos(angle), height * std::sin(angle), 1);
  }
  if (kind % 3 == 1) corners.emplace_back(0, 0, 1);
  for (int i = 0; i < 7 && kind % 3 == 2; ++i) {
    const double level = i < 4 ? 0 : i < 6 ? width : width * height;
    corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, level);
  }
  return ConvexHull(corners);
}

/// The middle of the one in or on the other, or beside it by a share of it, along an axis or not.
PlacedPair about(const Shape& shape_a, const Shape& shape_b, RandomSource& source) {
  PlacedPair pair{shape_a, shape_b, Pose::Identity(), Pose::Identity()};
  pair.pose_b.linear() = tests::right_turn(static_cast<std::size_t>(source.integer(0, 23)));
  if (source.integer(0, 2) == 0) {
    const Eigen::AngleAxisd turn{thin(source), source.vector(-1, 1).normalized()};
    pair.pose_b.linear() = turn.toRotationMatrix() * pair.pose_b.linear();
  }
  const int way = source.integer(0, 2);
  if (way == 1) pair.pose_b.translation() = source.vector(-0.4, 0.4);
  if (way == 2) pair.pose_b.translation()[source.integer(0, 2)] = source.uniform(-0.5, 0.5);
  return pair;
}

TEST(SpecialPoses, ContactsOfNeedlesStandOnThem) {
  tests::PairLawCounts counts;
  RandomSource source(95);
  for (std::size_t n = 0; n < 6000; ++n) {
    const Shape first = needle(n / 8, source);
    const Shape other = n % 8 == 7 ? first : tests::plain_shape(tests::kOwnKinds[n % 7], n / 49);
    const PlacedPair pair = about(first, other, source);
    ASSERT_EQ(broken_law(pair, {.directions = 100}, counts), "") << text_of(pair);
  }
  EXPECT_GT(counts.hits, 4000u);
}

// Of ways across the large one's axis that are equally long to rounding, from an end or beside it,
// one alone is at right angles to that.
TEST(SpecialPoses, TinyCapsulesAtTheEndOfALargeOnesSideLeaveAcrossIt) {
  tests::PairLawCounts counts;
  RandomSource source(96);
  for (int n = 0; n < 3000; ++n) {
    const double small = std::pow(10.0, source.uniform(-9, -5));
    PlacedPair pair{Capsule{source.uniform(0.3, 2), 1},
                    Capsule{small, small * source.uniform(0.2, 2)}, Pose::Identity(),
                    tests::random_pose(0, source)};
    const double angle = source.uniform(0, 7);
    const double reach = pair.a.as<Capsule>()->radius;
    pair.pose_b.translation() = Vector3d(reach * std::cos(angle), reach * std::sin(angle),
                                         1 - small * source.uniform(-2, 2));
    ASSERT_EQ(broken_law(pair, {.directions = 100}, counts), "") << text_of(pair);
  }
  EXPECT_GT(counts.hits, 1500u);
}

/// How far contacts of a pair lie off the surfaces that they name, as a share of the scale.
double farthest_off(const PlacedPair& pair) {
  const Surface of_a(pair.a), of_b(pair.b);
  double farthest = 0;
  for (const ShapeContact& contact : find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b})) {
    farthest = std::max(farthest, of_a.distance(pair.pose_a, contact.point_a));
    farthest = std::max(farthest, of_b.distance(pair.pose_b, contact.point_b));
  }
  return farthest / scale_of(pair);
}

Mesh triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return Mesh(std::vector<Vector3d>{a, b, c}, std::vector<TriangleIndices>{{0, 1, 2}});
}

// A corner that is cut off next to the tip of a triangle may lie past it by rounding over the tip's
// angle.
TEST(SpecialPoses, ContactsOnNeedleTrianglesDoNotLiePastTheirTips) {
  RandomSource source(97);
  constexpr ShapeKind kKinds[] = {ShapeKind::Box, ShapeKind::Cylinder, ShapeKind::ConvexHull};
  for (std::size_t n = 0; n < 6000; ++n) {
    const Mesh blade = triangle({-1, 0, 0}, {1, 0, 0}, {source.uniform(-1, 1), thin(source), 0});
    const PlacedPair pair = about(tests::plain_shape(kKinds[n % 3], n / 3), blade, source);
    ASSERT_LE(farthest_off(pair), 0x1p-32) << n;
  }
}

// Far from the origin placing leaves nothing of it but a point or a line: there it is touched.
TEST(SpecialPoses, ContactsOnTrianglesWithoutAreaStandOnThem) {
  RandomSource source(99);
  for (std::size_t n = 0; n < 3000; ++n) {
    const double along = n % 3 == 0 ? 1 : 1e-10;
    PlacedPair pair{tests::plain_shape(tests::kOwnKinds[n % 7], n / 7),
                    triangle({-along, 0, 0}, {along, 0, 0}, {0, 1e-14, 0}),
                    tests::random_pose(0, source), tests::random_pose(0, source)};
    const Vector3d far = source.vector(-1, 1) * 1e5;
    pair.pose_a.translation() += far;
    pair.pose_b.translation() += far + source.vector(-0.1, 0.1);
    ASSERT_LE(farthest_off(pair), 0x1p-32 + 1e-14 * far.norm()) << n;
  }
}

// There the corner leads no way out of the capsule: which is the rounding of its distance.
TEST(SpecialPoses, ACornerOnTheAxisOfACapsuleLeavesThroughItsSurface) {
  RandomSource source(98);
  for (int n = 0; n < 3000; ++n) {
    const Capsule capsule{source.uniform(0.2, 1), source.uniform(0.2, 1)};
    const Vector3d p = source.vector(-0.1, 0.1), q = source.vector(-1, 1), r = source.vector(-1, 1);
    PlacedPair pair{capsule, triangle(p, q, r), tests::random_pose(0, source),
                    tests::random_pose(0, source)};
    const Vector3d on_axis(0, 0, n % 4 == 0 ? capsule.half_length : source.uniform(-0.2, 0.2));
    pair.pose_b.translation() =
        pair.pose_a * on_axis - pair.pose_b.linear() * pair.b.as<Mesh>()->vertices()[0];
    ASSERT_LE(farthest_off(pair), 0x1p-32) << n;
  }
}

ConvexHull rod(RandomSource& source) {
  const double width = std::pow(10.0, source.uniform(-8, -5));
  std::vector<Vector3d> corners;
  const int count = 5 + static_cast<int>(source.integer(0, 5));
  for (int i = 0; i < count; ++i)
    corners.push_back(Vector3d{source.uniform(-width, width), source.uniform(-width, width),
                               source.uniform(-1, 1)});
  return ConvexHull(corners);
}

// Seen along a way that leans from its face's normal, the polygon of an uneven face need not be
// convex: its corners were moved off the edge of the mesh that they were to lie on.
TEST(SpecialPoses, ContactsOfRodsWithEdgesOfMeshesStandOnBoth) {
  tests::PairLawCounts counts;
  RandomSource source(104);
  for (int n = 0; n < 4000; ++n) {
    const Vector3d half = source.vector(0.1, 1);
    PlacedPair pair{rod(source), tests::make_box(half), Pose::Identity(),
                    tests::random_pose(0, source)};
    if (n % 2 == 0)
      pair.pose_b.linear() = tests::right_turn(static_cast<std::size_t>(source.integer(0, 23)));
    pair.pose_b.translation() = source.vector(-0.2, 0.2) * (n % 3 == 0 ? 0 : 1);
    ASSERT_EQ(broken_law(pair, {.directions = 100}, counts), "") << n << "\n" << text_of(pair);
  }
  EXPECT_GT(counts.hits, 3000u);
}

// Their triangles are so nearly in one plane that one was taken for the other's continuation, and a
// point of the plane for one of both.
TEST(SpecialPoses, ContactsOfThinSolidsStandOnTheTriangleThatIsMet) {
  RandomSource source(201);
  for (std::size_t n = 0; n < 6000; ++n) {
    const double t = std::pow(10.0, source.uniform(-9, -8));
    const std::vector<Vector3d> corners{{1, t, 1}, {1, -t, -1}, {-1, t, -1}, {-1, -t, 1}};
    const std::vector<TriangleIndices> triangles{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    const ShapeKind kind = n % 2 == 0 ? ShapeKind::Capsule : ShapeKind::Cone;
    PlacedPair pair{tests::plain_shape(kind, n), Mesh(corners, triangles),
                    tests::random_pose(0, source), tests::random_pose(0, source)};
    pair.pose_a.translation().setZero();
    pair.pose_b.translation() = source.vector(-0.2, 0.2);
    ASSERT_LE(farthest_off(pair), 0x1p-32) << n;
  }
}

}  // namespace
}  // namespace graze
