#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

template <typename T>
void expect_refused(const T& value, const std::string& says) {
  try {
    const Shape shape(value);
    ADD_FAILURE() << "taken, but should say: " << says;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), says);
  }
}

TEST(Law10Shape, TheDoorNamesShapeAndMember) {
  expect_refused(Sphere{{0, kNan, 0}, 1},
                 "sphere: coordinate y of the centre is not finite or beyond the largest length");
  expect_refused(Sphere{{0, 0, 0}, 0}, "sphere: the radius is not positive");
  expect_refused(Sphere{{0, 0, 0}, kInfinity}, "sphere: the radius is not finite");
  expect_refused(Box{{1, 0, 1}}, "box: half extent y is not positive");
  expect_refused(Box{{1, 1, -2}}, "box: half extent z is not positive");
  expect_refused(Capsule{-1, 1}, "capsule: the radius is not positive");
  expect_refused(Capsule{1, kNan}, "capsule: the half length is not finite");
  expect_refused(Cylinder{1, 0}, "cylinder: the half height is not positive");
  expect_refused(Cylinder{1e101, 1}, "cylinder: the radius is beyond the largest length");
  expect_refused(Cone{1e-101, 1}, "cone: the radius is below the smallest length");
  expect_refused(Ellipsoid{{0, 0, 0}, {1, kNan, 1}}, "ellipsoid: semi-axis y is not finite");
  expect_refused(HalfSpace{{0, 0, 0}, 1}, "half-space: the normal is zero");
  expect_refused(HalfSpace{{0, 0, 1}, kNan},
                 "half-space: the offset is not finite or beyond the largest length");
  EXPECT_NO_THROW(Shape(Capsule{1, 0}));
}

TEST(Law10Shape, HullsWithoutVolumeAreRefused) {
  const auto refusal = [](std::vector<Vector3d> points) -> std::string {
    try {
      const ConvexHull hull(points);
      return "taken";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal({}), "convex hull: no points");
  EXPECT_EQ(refusal({{1, 1, 1}, {1, 1, 1}}), "convex hull: no volume, all points are equal");
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}),
            "convex hull: no volume, all points lie on a line");
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}),
            "convex hull: no volume, all points lie in a plane");
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, kNan}}),
            "convex hull: point 1: coordinate z is not finite or beyond the largest length");
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-300}}), "taken");
}

TEST(ConvexHull, ACubeOfLatticePointsHasEightCornersAndSixFaces) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 125; ++i)
    points.emplace_back(i % 5, i / 5 % 5, i / 25);
  const ConvexHull hull(points);
  EXPECT_EQ(hull.vertex_count(), 8u);
  EXPECT_EQ(hull.face_count(), 6u);
  ASSERT_EQ(hull.facet_count(), 6u);
  for (std::size_t i = 0; i < hull.facet_count(); ++i) {
    const std::span<const std::uint32_t> facet = hull.facet(i);
    ASSERT_EQ(facet.size(), 4u);
    const Vector3d normal = (hull.vertex(facet[1]) - hull.vertex(facet[0]))
                                .cross(hull.vertex(facet[2]) - hull.vertex(facet[1]));
    for (const std::uint32_t corner : facet)
      EXPECT_EQ(normal.dot(hull.vertex(corner) - hull.vertex(facet[0])), 0);
    EXPECT_GT(normal.dot(hull.vertex(facet[0]) - Vector3d(2, 2, 2)), 0) << "seen from outside";
  }
  EXPECT_THROW(hull.facet(6), std::out_of_range);
}

TEST(ConvexHull, HoldsItsPointsAndSatisfiesEuler) {
  RandomSource source(5);
  for (int n = 0; n < 200; ++n) {
    std::vector<Vector3d> points;
    const int count = static_cast<int>(source.integer(5, 60));
    for (int i = 0; i < count; ++i)
      points.push_back(n % 2 == 0 ? source.vector(-1, 1) : source.lattice_point(-2, 2));
    points.insert(points.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const Shape shape{ConvexHull(points)};
    for (const Vector3d& p : points)
      ASSERT_LE(tests::outside_by(shape, Pose::Identity(), p), 1e-14) << n;
    const narrowphase::Hull& hull = data_of(*shape.as<ConvexHull>());
    ASSERT_EQ(hull.corners.size() + hull.faces.size(), hull.loops.size() / 2 + 2) << n;
  }
}

TEST(ShapeBounds, OutwardAndTight) {
  RandomSource source(6);
  for (int n = 0; n < 2000; ++n) {
    const ShapeKind kind = tests::kOwnKinds[n % tests::kOwnKinds.size()];
    if (kind == ShapeKind::HalfSpace) continue;
    const double size = std::pow(10.0, source.integer(-6, 6));
    const Shape shape = tests::random_shape(kind, size, source);
    const Pose pose = tests::random_pose(n % 3 == 0 ? 1e7 : size, source);
    const Aabb box = bounding_aabb({shape, pose});
    const double rounding = 1e-15 * pose.translation().cwiseAbs().maxCoeff() + 1e-14 * size;
    for (int i = 0; i < 3; ++i) {
      const double high = tests::reach_along(shape, pose, Vector3d::Unit(i));
      const double low = -tests::reach_along(shape, pose, -Vector3d::Unit(i));
      ASSERT_GE(box.max[i], high - rounding) << n;
      ASSERT_LE(box.min[i], low + rounding) << n;
      if (kind == ShapeKind::Mesh) continue;
      const double room = rounding + 1e-13 * size;
      ASSERT_LE(box.max[i], high + room) << n << name_of(kind);
      ASSERT_GE(box.min[i], low - room) << n << name_of(kind);
    }
  }
}

TEST(ShapeBounds, OutwardToTheLastBit) {
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(0.1, 1e9, -0.3);
  const Aabb box = bounding_aabb({Sphere{{0, 0, 0}, 0.1}, pose});
  // In long double these sums are exact enough to tell the side.
  for (int i = 0; i < 3; ++i) {
    const long double t = pose.translation()[i];
    EXPECT_GE(static_cast<long double>(box.max[i]), t + 0.1L);
    EXPECT_LE(static_cast<long double>(box.min[i]), t - 0.1L);
  }
}

/// By law 3 a point is in a box if R^T (p - t) is: where R is hardly a rotation, that is not where
/// R places the box.
TEST(ShapeBounds, HoldABoxAsLaw3ReadsIt) {
  RandomSource source(8);
  const Shape shape = Box{{1, 2, 3}};
  for (int n = 0; n < 300; ++n) {
    Pose pose = tests::random_pose(1, source);
    if (n % 2 == 0) pose.linear().setIdentity();
    for (int i = 0; i < 9; ++i)
      pose.matrix()(i / 3, i % 3) += source.uniform(-2e-7, 2e-7);
    const Aabb box = bounding_aabb({shape, pose});
    const Eigen::Matrix3d back = pose.linear().transpose().inverse();
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const Vector3d read = pose.translation() + back * sign.cwiseProduct(Vector3d(1, 2, 3));
      ASSERT_TRUE((read - box.min).minCoeff() >= 0 && (box.max - read).minCoeff() >= 0) << n;
    }
  }
}

/// What boxes part is apart, whatever a tolerance would say; contacts and distances agree.
TEST(ShapeBounds, NoPairTouchesThatTheyPart) {
  RandomSource source(9);
  for (int n = 0; n < 6000; ++n) {
    const Shape a = tests::random_shape(tests::kOwnKinds[n % 7], 1, source);
    const Shape b = tests::random_shape(tests::kOwnKinds[n / 7 % 7], 1, source);
    Pose place = Pose::Identity(), other = Pose::Identity();
    other.translation() = source.vector(-0.05, 0.05);
    const Aabb of_a = bounding_aabb({a, place}), of_b = bounding_aabb({b, other});
    const double gap = std::exp2(source.uniform(-56, -24));
    other.translation()[n % 3] += of_a.max[n % 3] + gap - of_b.min[n % 3];
    const BoxGap boxes = gap_between(of_a, bounding_aabb({b, other}));
    if (boxes.gap == 0) continue;
    ASSERT_FALSE(intersects({a, place}, {b, other})) << name_of(a.kind()) << name_of(b.kind());
    ASSERT_TRUE(find_contacts({a, place}, {b, other}).empty());
    ASSERT_GE(distance({a, place}, {b, other}).distance, boxes.gap);
    ASSERT_GE(distance({b, other}, {a, place}).distance, boxes.gap);
  }
}

TEST(ShapeBounds, OfHalfSpacesReachToTheLargestDoubles) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const Aabb floor = bounding_aabb({HalfSpace{{0, 0, 2}, 3}, Pose::Identity()});
  EXPECT_GE(floor.max.z(), 1.5);
  EXPECT_LE(floor.max.z(), 1.5 + 1e-13);
  EXPECT_EQ(floor.min.z(), -kLargest);
  EXPECT_EQ(floor.max.x(), kLargest);
  const Aabb tilted = bounding_aabb({HalfSpace{{0, 1, 1}, 0}, Pose::Identity()});
  EXPECT_EQ(tilted.max.z(), kLargest);
  EXPECT_NO_THROW(check_box(tilted, "tilted"));
}

TEST(Law10Shape, PosesAreChecked) {
  Pose pose = Pose::Identity();
  pose.translation().x() = 1e101;
  EXPECT_THROW(bounding_aabb({Box{{1, 1, 1}}, pose}), PoseError);
  pose.translation().x() = kNan;
  EXPECT_THROW(bounding_aabb({Box{{1, 1, 1}}, pose}), PoseError);
  pose = Pose::Identity();
  pose.linear() *= 1.1;
  EXPECT_THROW(bounding_aabb({Box{{1, 1, 1}}, pose}), PoseError);
}

}  // namespace
}  // namespace graze
