// What two boxes' own axes are sure of is what the separating axis test with its slack says.

#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/depth/box_axes.h>
#include <graze/narrowphase/volumes/obb_rows.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using narrowphase::Verdict;

bool may_overlap(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  return narrowphase::may_overlap(narrowphase::row_of({pose_a, a.half_extents}),
                                  narrowphase::row_of({pose_b, b.half_extents}));
}

Verdict verdict(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const Eigen::Vector3d origin = middle_of(a, pose_a);
  const narrowphase::Core core_a = core_of(a, pose_a, origin), core_b = core_of(b, pose_b, origin);
  return narrowphase::BoxAxes(core_a, core_b).verdict();
}

/// How far along the way B is when the two part.
double parting_way(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b,
                   const Eigen::Vector3d& way) {
  double low = 0, high = 100;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    Pose there = pose_b;
    there.translation() += way * middle;
    (may_overlap(a, pose_a, b, there) ? low : high) = middle;
  }
  return low;
}

/// At a distance of 1 to 2^-45 from parting, on both sides.
TEST(BoxAxes, AreSureOnlyOfWhatTheSeparatingAxisTestSays) {
  RandomSource source(5);
  int all = 0, sure = 0, sure_far_out = 0, far_out = 0;
  for (int n = 0; n < 4000; ++n) {
    const Shape shape_a = tests::random_shape(ShapeKind::Box, 1, source);
    const Shape shape_b = tests::random_shape(ShapeKind::Box, 1, source);
    const Box &a = *shape_a.as<Box>(), &b = *shape_b.as<Box>();
    const double far = n % 3 == 0 ? 1e6 : 1;
    Pose pose_a = tests::random_pose(far, source), pose_b = tests::random_pose(far, source);
    if (n % 2 == 0) pose_a = tests::distorted(pose_a, 3e-7, source);
    if (n % 2 == 0) pose_b = tests::distorted(pose_b, 3e-7, source);
    if (n % 5 == 0) pose_b.linear() = pose_a.linear();
    pose_b.translation() = pose_a.translation();
    const Eigen::Vector3d way = source.vector(-1, 1).normalized();
    const double parting = parting_way(a, pose_a, b, pose_b, way);
    const double away = std::exp2(-source.uniform(0, 45));
    pose_b.translation() += way * (parting + (n % 7 < 3 ? -away : away));
    const bool is_hit = may_overlap(a, pose_a, b, pose_b);
    for (const Verdict found : {verdict(a, pose_a, b, pose_b), verdict(b, pose_b, a, pose_a)}) {
      EXPECT_NE(found, is_hit ? Verdict::No : Verdict::Yes) << n;
      ++all;
      sure += found != Verdict::Unsure;
      const bool is_far_out = away > 1e-3 && n % 5 != 0;
      far_out += is_far_out;
      sure_far_out += is_far_out && found != Verdict::Unsure;
    }
  }
  EXPECT_GT(sure, all / 5);
  EXPECT_LT(sure, all);
  EXPECT_GT(sure_far_out, 0.9 * far_out);
}

}  // namespace
}  // namespace graze
