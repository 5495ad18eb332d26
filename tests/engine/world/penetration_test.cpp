// The two ways to a depth: the expanding polytope, which proves it, and libccd, which is asked
// where that ends open. libccd must come back from whatever it is asked, and is never believed.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/depth/aligned_parting.h>
#include <graze/narrowphase/convex/depth/expanding_polytope.h>
#include <graze/narrowphase/convex/depth/penetration.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

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
  const auto kind = [&] {
    return tests::kOwnKinds[static_cast<std::size_t>(source.integer(0, 6))];
  };
  const Shape a = tests::random_shape(kind(), 1, source);
  const Shape b = tests::random_shape(kind(), 1, source);
  const Pose pose_a = tests::random_pose(reach, source);
  return {a, b, pose_a, tests::random_pose(reach, source)};
}

double size_of(const Core& core) {
  return core.bounding_radius + core.radius;
}

TEST(Penetration, ThePolytopeProvesNearlyAll) {
  RandomSource source(31);
  int hits = 0, open = 0, ccd_failed = 0, ccd_too_deep = 0;
  for (int n = 0; n < 3000; ++n) {
    const Pair pair = random_pair(0.3, source);
    if (!intersects({pair.a, pair.pose_a}, {pair.b, pair.pose_b})) continue;
    ++hits;
    const Eigen::Vector3d origin = middle_of(pair.a, pair.pose_a);
    const Core a = core_of(pair.a, pair.pose_a, origin);
    const Core b = core_of(pair.b, pair.pose_b, origin);
    const double size = std::min(size_of(a), size_of(b));
    const narrowphase::PolytopeDepth found = polytope_depth(a, b, 1e-6 * size);
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

/// Two that lie along the same axes, permuted, at an offset that keeps the formula's conditions, or
/// not.
Pair aligned_pair(int n, RandomSource& source) {
  const auto any = [&](std::initializer_list<ShapeKind> kinds) {
    const auto last = static_cast<int>(kinds.size()) - 1;
    return kinds.begin()[static_cast<std::size_t>(source.integer(0, last))];
  };
  using enum ShapeKind;
  const bool is_turned = n % 2 == 0;
  const auto kind = [&] {
    return is_turned ? any({Capsule, Cylinder, Cone, Sphere})
                     : any({Box, Capsule, Cylinder, Ellipsoid, Sphere});
  };
  const Shape a = tests::random_shape(kind(), 1, source);
  const Shape b = tests::random_shape(kind(), 1, source);
  Pose pose_a = tests::random_pose(0.3, source);
  Pose own = Pose::Identity();
  if (is_turned) {
    own.rotate(Eigen::AngleAxisd(source.uniform(-3, 3), Eigen::Vector3d::UnitZ()));
    if (n % 4 == 0) own.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
    if (n % 3 == 0) own.translation().z() = source.uniform(-0.5, 0.5);
  } else {
    for (int i = 0; i < n % 5; ++i)
      own.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::Unit(i % 3)));
    if (n % 3 == 0) own.translation() = source.vector(-0.2, 0.2);
  }
  // Shapes with a centre of their own are put where it is at the origin.
  const auto centred = [](const Shape& shape, Pose pose) {
    pose.translation() += pose.translation() - middle_of(shape, pose);
    return pose;
  };
  Pose pose_b = pose_a * own;
  return {a, b, centred(a, pose_a), centred(b, pose_b)};
}

TEST(Penetration, OfAlignedSetsIsTheLeastByFormula) {
  RandomSource source(33);
  int known = 0, with_cone = 0, with_offset = 0;
  for (int n = 0; n < 1500; ++n) {
    const Pair pair = aligned_pair(n, source);
    if (!intersects({pair.a, pair.pose_a}, {pair.b, pair.pose_b})) continue;
    const Eigen::Vector3d origin = middle_of(pair.a, pair.pose_a);
    const Core a = core_of(pair.a, pair.pose_a, origin);
    const Core b = core_of(pair.b, pair.pose_b, origin);
    const double tolerance = 1e-6 * std::min(size_of(a), size_of(b));
    const auto found = narrowphase::part_aligned(a, b, tolerance);
    if (!found) continue;
    ++known;
    with_cone += pair.a.kind() == ShapeKind::Cone || pair.b.kind() == ShapeKind::Cone;
    with_offset += length(b.at - a.at) > 0.01;
    ASSERT_EQ(found->depth, along(a, b, found->normal).depth);
    const narrowphase::PolytopeDepth proof = polytope_depth(a, b, tolerance);
    ASSERT_GE(found->depth, proof.lower - 1e-12) << n;
    ASSERT_LE(found->depth, proof.upper + tolerance) << n;
    const Vec3& normal = found->normal;
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d d = source.vector(-1, 1);
      const Vec3 far = unit_or(Vec3{d.x(), d.y(), d.z()}, normal);
      const Vec3 near = unit_or(normal + far * (i % 2 == 0 ? 0.1 : 1e-3), normal);
      for (const Vec3& direction : {far, near})
        ASSERT_GE(along(a, b, direction).depth, found->depth - tolerance) << n;
    }
  }
  RecordProperty("known", known);
  EXPECT_GT(known, 900);
  EXPECT_GT(with_cone, 200);
  EXPECT_GT(with_offset, 200);
}

// So far off that the formula is not sure, and so little that it is, to the tolerance.
TEST(Penetration, OfSetsThatAreNotQuiteAlignedIsLeftToThePolytope) {
  const Shape a = Cylinder{0.5, 0.7}, b = Cylinder{0.4, 0.6};
  for (const double angle : {1e-3, 1e-5, 1e-8, 1e-12}) {
    Pose pose = Pose::Identity();
    pose.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d(0.6, 0.8, 0)));
    const Core core_a = core_of(a, Pose::Identity(), {0, 0, 0});
    const Core core_b = core_of(b, pose, {0, 0, 0});
    const auto found = narrowphase::part_aligned(core_a, core_b, 1e-6 * size_of(core_b));
    EXPECT_EQ(found.has_value(), angle < 1e-7) << angle;
    EXPECT_NEAR(found ? found->depth : 0.9, 0.9, 1e-6);
  }
}

TEST(Penetration, OfCoincidentSetsIsProved) {
  RandomSource source(34);
  for (int n = 0; n < 200; ++n) {
    const ShapeKind kind = tests::kOwnKinds[static_cast<std::size_t>(n) % 6];
    const Shape shape = tests::random_shape(kind, 1, source);
    const Pose pose = tests::random_pose(1, source);
    Work work;
    ASSERT_FALSE(find_contacts({shape, pose}, {shape, pose}, &work).empty());
    EXPECT_EQ(work.penetration_failures, 0u) << name_of(kind);
  }
}

TEST(Penetration, LibccdGivesUpOnWhatIsNotANumber) {
  Core a;
  a.kind = narrowphase::CoreKind::Box;
  a.half = {1, 1, 1};
  a.bounding_radius = 2;
  Core b = a;
  b.at.x = std::nan("");
  EXPECT_FALSE(ask_ccd(a, b).has_value());
}

}  // namespace
}  // namespace graze
