// Law 14 for shapes: every pair of kinds beside samples, and times that are known.

#include <graze/bvh/error.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

std::vector<Shape> all_shapes() {
  return {Sphere{{0.1, 0, 0}, 0.4},
          Box{{0.5, 0.25, 0.125}},
          Capsule{0.125, 0.5},
          Cylinder{0.25, 0.5},
          Cone{0.5, 0.5},
          Ellipsoid{{0, 0, 0}, {0.5, 0.25, 0.125}},
          ConvexHull(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
          HalfSpace{{0, 0, 1}, -0.5},
          tests::make_torus(0.5, 0.125, 12, 8)};
}

RigidMotion drawn_motion(RandomSource& source) {
  const Pose start = tests::random_pose(2, source);
  const Eigen::Vector3d centre = source.vector(-1, 1);
  const Eigen::Vector3d shift = source.vector(-2, 2);
  const Eigen::Vector3d axis = source.vector(-1, 1);
  return {start, {.centre = centre, .shift = shift, .axis = axis, .angle = source.uniform(-3, 3)}};
}

TEST(Law14Shapes, EveryPairIsSoundBesideSamples) {
  RandomSource source(1440);
  const std::vector<Shape> shapes = all_shapes();
  int counts[3] = {0, 0, 0};
  for (std::size_t i = 0; i < 3 * shapes.size() * shapes.size(); ++i) {
    const Shape& a = shapes[i % shapes.size()];
    const Shape& b = shapes[i / shapes.size() % shapes.size()];
    if (a.kind() == ShapeKind::HalfSpace && b.kind() == ShapeKind::HalfSpace) continue;
    const RigidMotion motion_a = drawn_motion(source), motion_b = drawn_motion(source);
    const RigidContactSettings settings{.clearance = i % 4 == 0 ? 0.05 : 0};
    const RigidContact found = first_contact({a, motion_a}, {b, motion_b}, settings);
    ++counts[static_cast<int>(found.status)];
    const auto gap = [&](double t) { return distance({a, motion_a.at(t)}, {b, motion_b.at(t)}); };
    for (int k = 0; k < 60 && found.low > 0; ++k) {
      const double t = found.low * k / 60;
      ASSERT_GT(gap(t).distance, settings.clearance) << i << " at " << t;
    }
    if (found.status == RigidStatus::Hit) {
      EXPECT_LE(gap(found.high).distance, settings.clearance);
      EXPECT_LE(found.low, found.high);
    }
    if (found.status == RigidStatus::Free) {
      EXPECT_GT(gap(1).distance, settings.clearance);
    } else {
      EXPECT_LE(gap(found.low).lower_bound, settings.clearance + 1e-6);
    }
    EXPECT_EQ(found, first_contact({b, motion_b}, {a, motion_a}, settings));
    EXPECT_EQ(is_free({a, motion_a}, {b, motion_b}, settings), found.status == RigidStatus::Free);
  }
  EXPECT_GT(counts[0], 20);
  EXPECT_GT(counts[1], 20);
}

TEST(Law14Shapes, TimesThatAreKnown) {
  const HalfSpace ground{{0, 0, 1}, 0};
  const RigidMotion rest(Pose::Identity());
  const RigidMotion falls(tests::at(0, 0, 2.5), {.shift = {0, 0, -4}});
  const RigidContact ball = first_contact({ground, rest}, {Sphere{{0, 0, 0}, 0.5}, falls});
  EXPECT_EQ(ball.status, RigidStatus::Hit);
  EXPECT_LE(ball.low, 0.5);
  EXPECT_NEAR(ball.low, 0.5, 1e-6);
  EXPECT_NEAR(ball.high, 0.5, 1e-6);
  // A rod that topples about its foot meets a wall.
  const Capsule rod{0.125, 1};
  const RigidMotion topples(tests::at(0, 0, 1), {.axis = {0, 1, 0}, .angle = 1});
  const Box wall{{0.5, 4, 4}};
  const RigidContact met = first_contact({wall, RigidMotion(tests::at(1.5, 0, 0))}, {rod, topples});
  EXPECT_EQ(met.status, RigidStatus::Hit);
  EXPECT_NEAR(met.high, std::asin((1 - 0.125) / 2), 2e-6);
  // A half-space that turns away, and one that turns into a ball far from its centre.
  EXPECT_TRUE(is_free({ground, RigidMotion(Pose::Identity(), {.axis = {0, 1, 0}, .angle = 0.5})},
                      {Sphere{{8, 0, 1}, 0.5}, rest}));
  const RigidContact turned =
      first_contact({ground, RigidMotion(Pose::Identity(), {.axis = {0, 1, 0}, .angle = -0.5})},
                    {Sphere{{8, 0, 1}, 0.5}, rest});
  EXPECT_EQ(turned.status, RigidStatus::Hit);
  const double angle = std::atan2(1, 8) - std::asin(0.5 / std::sqrt(65.0));
  EXPECT_NEAR(turned.high, angle / 0.5, 1e-6);
}

TEST(Law14Shapes, TwoMeshesAreAskedAsMeshesAreAndWhatCannotBeIsRefused) {
  const Mesh torus = tests::make_torus(0.5, 0.125, 12, 8);
  const RigidMotion rest(Pose::Identity());
  const RigidMotion motion(tests::at(2), {.shift = {-2, 0, 0}, .angle = 1});
  EXPECT_EQ(first_contact({Shape(torus), rest}, {Shape(torus), motion}),
            first_contact({torus, rest}, {torus, motion}));
  const HalfSpace ground{{0, 0, 1}, 0};
  EXPECT_THROW(first_contact({ground, RigidMotion(Pose::Identity(), {.angle = 1})}, {ground, rest}),
               UnsupportedPairError);
  const Sphere ball{{0, 0, 0}, 1};
  EXPECT_THROW(first_contact({ball, rest}, {ball, rest}, {.tolerance = -1}), InputError);
  const RigidMotion far(Pose::Identity(), {.shift = {1e200, 0, 0}});
  EXPECT_THROW(first_contact({ball, rest}, {ball, far}), PoseError);
  EXPECT_THROW(first_contact({ground, far}, {ball, rest}), PoseError);
  const RigidContact none =
      first_contact({ball, RigidMotion(tests::at(9))}, {ball, rest}, {.budget = 0});
  EXPECT_TRUE(none.status == RigidStatus::Close && none.is_out_of_budget && none.low == 0);
}

}  // namespace
}  // namespace graze
