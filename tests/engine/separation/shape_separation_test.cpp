// Signed distances of convex shapes: formulas, what distance() and find_contacts() say, and that
// they tell how to part two shapes.

#include <graze/bvh/error.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_separation.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using tests::at;

TEST(ShapeSeparation, OfBallsIsTheDifferenceOfDistanceAndRadii) {
  RandomSource source(51);
  int inside = 0;
  for (int n = 0; n < 500; ++n) {
    const Sphere a{source.vector(-1, 1), source.uniform(0.1, 1)};
    const Sphere b{source.vector(-1, 1), source.uniform(0.1, 1)};
    const ShapeSeparation found = find_separation({a}, {b});
    EXPECT_NEAR(found.distance, (b.centre - a.centre).norm() - a.radius - b.radius, 1e-14);
    EXPECT_NEAR((found.point_a - a.centre).norm(), a.radius, 1e-14);
    EXPECT_NEAR((found.point_b - b.centre).norm(), b.radius, 1e-14);
    inside += found.distance < 0;
  }
  EXPECT_GT(inside, 100);
}

TEST(ShapeSeparation, OfBoxesAlongTheSameAxes) {
  RandomSource source(52);
  int inside = 0;
  for (int n = 0; n < 500; ++n) {
    const Eigen::Vector3d half_a = source.vector(0.2, 1), half_b = source.vector(0.2, 1);
    const Eigen::Vector3d offset = source.vector(-1.5, 1.5);
    const ShapeSeparation found =
        find_separation({Box{half_a}}, {Box{half_b}, at(offset.x(), offset.y(), offset.z())});
    const Eigen::Vector3d gap = offset.cwiseAbs() - half_a - half_b;
    const double expected =
        gap.maxCoeff() < 0 ? gap.maxCoeff() : gap.cwiseMax(Eigen::Vector3d::Zero()).norm();
    EXPECT_NEAR(found.distance, expected, 1e-12);
    inside += found.distance < 0;
  }
  EXPECT_GT(inside, 50);
}

TEST(ShapeSeparation, AboveAndBelowAPlane) {
  const Shape plane = HalfSpace{{0, 0, 2}, 0};
  for (const double height : {3.0, 1.5, 1.0, 0.5, -0.5, -7.0}) {
    const ShapeSeparation found = find_separation({plane}, {Box{{1, 1, 1}}, at(0, 0, height)});
    EXPECT_EQ(found.distance, height - 1);
    EXPECT_EQ(found.normal, Eigen::Vector3d(0, 0, 1));
  }
  EXPECT_THROW(find_separation({plane}, {plane}), UnsupportedPairError);
  const Shape opposite = HalfSpace{{0, 0, -1}, -2};
  EXPECT_EQ(find_separation({plane}, {opposite}).distance, 2);
}

/// What the two queries behind it say, and what swapping changes.
TEST(ShapeSeparation, AgreesWithDistanceContactsAndItsMirror) {
  RandomSource source(53);
  int inside = 0, apart = 0;
  for (int n = 0; n < 1500; ++n) {
    const Shape a =
        tests::random_shape(tests::kOwnKinds[static_cast<std::size_t>(n % 7)], 1, source);
    const Shape b =
        tests::random_shape(tests::kOwnKinds[static_cast<std::size_t>(n / 7 % 7)], 1, source);
    const Pose pose_a = tests::random_pose(1, source), pose_b = tests::random_pose(1, source);
    const ShapeSeparation found = find_separation({a, pose_a}, {b, pose_b});
    const bool is_hit = intersects({a, pose_a}, {b, pose_b});
    EXPECT_EQ(found.distance > 0, !is_hit);
    if (found.distance > 0) {
      const ShapeDistance distance_said = distance({a, pose_a}, {b, pose_b});
      EXPECT_EQ(found, (ShapeSeparation{distance_said.distance, distance_said.point_a,
                                        distance_said.point_b, distance_said.normal,
                                        distance_said.status}));
    } else {
      const Manifold contacts = find_contacts({a, pose_a}, {b, pose_b});
      for (const ShapeContact& contact : contacts)
        EXPECT_LE(contact.depth, -found.distance);
      EXPECT_EQ(contacts[0].depth, -found.distance);
      EXPECT_EQ(contacts[0].point_a, found.point_a);
      EXPECT_EQ(contacts[0].point_b, found.point_b);
      EXPECT_EQ(contacts[0].normal, found.normal);
    }
    const ShapeSeparation swapped = find_separation({b, pose_b}, {a, pose_a});
    EXPECT_EQ(swapped, (ShapeSeparation{found.distance, found.point_b, found.point_a, -found.normal,
                                        found.status}));
    (is_hit ? inside : apart) += 1;
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(apart, 200);
}

// Along the normal by the depth, and a little more: the two are apart; by less they are not.
TEST(ShapeSeparation, IsTheWayOut) {
  RandomSource source(54);
  int parted = 0;
  for (int n = 0; n < 500; ++n) {
    const Shape a =
        tests::random_shape(tests::kOwnKinds[static_cast<std::size_t>(n % 7)], 1, source);
    const Shape b =
        tests::random_shape(tests::kOwnKinds[static_cast<std::size_t>(n / 7 % 7)], 1, source);
    const Pose pose = tests::random_pose(0.3, source);
    const ShapeSeparation found = find_separation({a}, {b, pose});
    if (found.distance >= -1e-3 || found.status != PairStatus::Converged) continue;
    const auto distance_after = [&](double share) {
      Pose moved = pose;
      moved.translation() -= share * found.distance * found.normal;
      return find_separation({a}, {b, moved}).distance;
    };
    EXPECT_GT(distance_after(1.01), 0) << n;
    EXPECT_LT(distance_after(0.9), 0) << n;
    ++parted;
  }
  EXPECT_GT(parted, 100);
}

TEST(Law10ShapeSeparation, MeshesAndBadPosesAreRefused) {
  const Shape mesh = tests::make_box({1, 1, 1}), box = Box{{1, 1, 1}};
  try {
    find_separation({box}, {mesh});
    FAIL();
  } catch (const UnsupportedPairError& error) {
    EXPECT_STREQ(error.what(),
                 "find_separation: shape B is a mesh, which is a surface and has no depth");
  }
  EXPECT_THROW(find_separation({mesh}, {box}), UnsupportedPairError);
  Pose skewed = Pose::Identity();
  skewed.matrix()(0, 1) = 0.1;
  EXPECT_THROW(find_separation({box, skewed}, {box}), PoseError);
  EXPECT_THROW(find_separation({box}, {box, skewed}), PoseError);
  Work work;
  find_separation({box}, {box, at(0.5, 0.25, 0.125)}, &work);
  EXPECT_EQ(work.penetration_failures, 0u);
}

}  // namespace
}  // namespace graze
