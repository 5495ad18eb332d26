// The two ways to a depth: the expanding polytope, which proves it, and libccd, which is asked
// where that ends open. libccd must come back from whatever it is asked, and is never believed.

#include <graze/engine/world/placed_core.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/narrowphase/convex/ccd.h>
#include <graze/narrowphase/convex/expanding_polytope.h>
#include <graze/narrowphase/convex/penetration.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using narrowphase::ask_ccd;
using narrowphase::Core;
using narrowphase::Vec3;

struct Pair {
  Shape a;
  Shape b;
  Pose pose_a;
  Pose pose_b;
};

Pair random_pair(double reach, RandomSource& source) {
  const auto kind = [&] { return kShapeKinds[static_cast<std::size_t>(source.integer(0, 6))]; };
  const Shape a = tests::random_shape(kind(), 1, source);
  const Shape b = tests::random_shape(kind(), 1, source);
  const Pose pose_a = tests::random_pose(reach, source);
  return {a, b, pose_a, tests::random_pose(reach, source)};
}

double size_of(const Core& core) {
  return core.reach + core.radius;
}

TEST(Penetration, ThePolytopeProvesNearlyAll) {
  RandomSource source(31);
  int hits = 0, open = 0, ccd_failed = 0, ccd_too_deep = 0;
  for (int n = 0; n < 3000; ++n) {
    const Pair pair = random_pair(0.3, source);
    if (!intersects(pair.a, pair.pose_a, pair.b, pair.pose_b)) continue;
    ++hits;
    const Eigen::Vector3d origin = middle_of(pair.a, pair.pose_a);
    const Core a = core_of(pair.a, pair.pose_a, origin);
    const Core b = core_of(pair.b, pair.pose_b, origin);
    const double size = std::min(size_of(a), size_of(b));
    const narrowphase::Expansion found = expand(a, b, 1e-6 * size);
    open += !found.is_closed;
    ASSERT_LE(found.lower, found.upper + 1e-13) << n;
    ASSERT_LE(found.upper - found.lower, 1e-3 * size) << n;
    const std::optional<Vec3> direction = ask_ccd(a, b);
    ccd_failed += !direction;
    if (!direction) continue;
    ASSERT_NEAR(length(*direction), 1, 1e-12);
    const double depth = along(a, b, *direction).depth;
    ASSERT_GE(depth, found.lower - 1e-12) << "what is proved was undercut, " << n;
    ccd_too_deep += depth > found.upper + 1e-4 * size;
  }
  RecordProperty("pairs", hits);
  RecordProperty("polytope_open", open);
  RecordProperty("ccd_failed", ccd_failed);
  RecordProperty("ccd_too_deep", ccd_too_deep);
  EXPECT_GT(hits, 2000);
  EXPECT_LT(open, hits / 200);
  EXPECT_LT(ccd_failed, hits / 50);
}

// Apart, touching, coincident, flat and of very different sizes: whatever comes back is a unit
// vector or nothing, after at most its budget of support points.
TEST(Penetration, LibccdComesBackFromAnything) {
  RandomSource source(32);
  for (int n = 0; n < 1500; ++n) {
    Pair pair = random_pair(0.5, source);
    if (n % 3 == 0) pair.b = Box{{1e6, 1e-6, 1}};
    if (n % 4 == 0) pair.pose_b = pair.pose_a;
    if (n % 5 == 0) pair.a = Cylinder{1, 1e-9};
    const Eigen::Vector3d origin = middle_of(pair.a, pair.pose_a);
    const Core a = core_of(pair.a, pair.pose_a, origin);
    Core b = core_of(pair.b, pair.pose_b, origin);
    if (n % 7 == 0) b.at = b.at + Vec3{0, 0, 1e3};
    if (const std::optional<Vec3> found = ask_ccd(a, b)) {
      ASSERT_NEAR(length(*found), 1, 1e-12) << n;
    }
    const narrowphase::Penetration way = penetration(a, b);
    ASSERT_NEAR(length(way.normal), 1, 1e-12) << n;
    ASSERT_TRUE(std::isfinite(way.depth)) << n;
  }
}

TEST(Penetration, LibccdGivesUpOnWhatIsNotANumber) {
  Core a;
  a.kind = narrowphase::CoreKind::Box;
  a.half = {1, 1, 1};
  a.reach = 2;
  Core b = a;
  b.at.x = std::nan("");
  EXPECT_FALSE(ask_ccd(a, b).has_value());
}

}  // namespace
}  // namespace graze
