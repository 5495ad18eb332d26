// A convex set that goes straight is only said to pass a triangle where the gap, at every time
// that is looked at, says so, too.

#include <graze/engine/world/rigid/swept_core.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using narrowphase::Core;
using narrowphase::Vec3;

const Eigen::Vector3d kOrigin(0, 0, 0);

Core upright_capsule(double z) {
  return core_of(Capsule{0.25, 0.5}, tests::at(0, 0, z), kOrigin);
}

TEST(SweptCore, PassesUntilTheRoomIsGone) {
  const Core floor = core_of(Triangle{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}}, kOrigin);
  const Core capsule = upright_capsule(2);  // 1.25 above the floor
  const SweptCore falling(capsule, {0, 0, -2.5}, 0.25);
  EXPECT_TRUE(falling.is_surely_passed(floor, 0.39));
  EXPECT_FALSE(falling.is_surely_passed(floor, 0.41));
  EXPECT_TRUE(SweptCore(capsule, {0, 0, 2.5}, 0.25).is_surely_passed(floor, 1));
  EXPECT_TRUE(SweptCore(capsule, {9, 0, 0}, 1.24).is_surely_passed(floor, 1));
  EXPECT_FALSE(SweptCore(capsule, {9, 0, 0}, 1.26).is_surely_passed(floor, 1));
  EXPECT_TRUE(SweptCore(capsule, {0, 0, 0}, 1.24).is_surely_passed(floor, 1));
}

TEST(SweptCore, PassesWhatIsBesideTheWay) {
  const Core capsule = upright_capsule(2);
  const SweptCore falling(capsule, {0, 0, -9}, 0.125);
  const auto is_passed_beside = [&](double x) {
    const Core wall = core_of(Triangle{{x, -4, 3}, {x, 4, 3}, {x, 0, -3}}, kOrigin);
    return falling.is_surely_passed(wall, 1);
  };
  EXPECT_TRUE(is_passed_beside(0.38));
  EXPECT_TRUE(is_passed_beside(-0.38));
  EXPECT_FALSE(is_passed_beside(0.37));
  EXPECT_FALSE(is_passed_beside(0));
}

TEST(SweptCore, SeesAlongANormalThatItTakes) {
  // Three centimetres from the shoulder of the capsule in the end, and within its box.
  const Eigen::Vector3d point(0.2, 0, -1.7);
  const Core shoulder = core_of(Triangle{point, point, point}, kOrigin);
  const Core capsule = upright_capsule(0);
  SweptCore swept(capsule, {0, 0, -1}, 0x1p-10);
  EXPECT_FALSE(swept.is_surely_passed(shoulder, 1));
  swept.take_normal({-0.70710678118654752, 0, 0.70710678118654752});
  EXPECT_TRUE(swept.is_surely_passed(shoulder, 1));
  EXPECT_FALSE(swept.is_surely_passed(shoulder, 1.1));
}

TEST(SweptCore, IsNeverWrongBesideGaps) {
  constexpr double kRoom = 0.0625;
  RandomSource source(311);
  const std::vector<Shape> shapes = {
      Capsule{0.125, 0.5}, Cylinder{0.25, 0.5}, Cone{0.5, 0.5},
      Ellipsoid{{0, 0, 0}, {0.5, 0.25, 0.125}},
      ConvexHull(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})};
  int passed = 0, left = 0;
  for (int n = 0; n < 4000; ++n) {
    const Eigen::Vector3d middle = source.vector(-1, 1);
    const Core triangle =
        core_of(Triangle{middle + source.vector(-0.5, 0.5), middle + source.vector(-0.5, 0.5),
                         middle + source.vector(-0.5, 0.5)},
                kOrigin);
    const Core core = core_of(shapes[static_cast<std::size_t>(n) % shapes.size()],
                              tests::random_pose(1, source), kOrigin);
    const Eigen::Vector3d shift = source.vector(-2, 2);
    const Vec3 way = to_vec3(shift);
    SweptCore swept(core, way, kRoom);
    const Eigen::Vector3d normal = source.vector(-1, 1).normalized();
    if (n % 2 == 0) swept.take_normal(to_vec3(normal));
    const double until = source.uniform(0, 1);
    if (!swept.is_surely_passed(triangle, until)) {
      ++left;
      continue;
    }
    ++passed;
    for (int step = 0; step <= 16; ++step) {
      Core moved = core;
      moved.at = core.at + way * (until * step / 16);
      EXPECT_GT(gap_of_sets(triangle, moved).distance, kRoom * (1 - 0x1p-30)) << n << " " << step;
    }
  }
  EXPECT_GT(passed, 1000);
  EXPECT_GT(left, 300);
}

}  // namespace
}  // namespace graze
