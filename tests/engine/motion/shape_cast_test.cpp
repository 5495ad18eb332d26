// Law 13 for shapes: every pair of kinds beside samples, times that are known, and beside exact
// casts.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

const Mesh kTorus = tests::make_torus(0.5, 0.125, 12, 8);

std::vector<Shape> all_kinds() {
  return {Sphere{{0.1, 0, 0}, 0.4},
          Box{{0.5, 0.25, 0.125}},
          Capsule{0.125, 0.5},
          Cylinder{0.25, 0.5},
          Cone{0.5, 0.5},
          Ellipsoid{{0, 0, 0}, {0.5, 0.25, 0.125}},
          ConvexHull(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
          HalfSpace{{0, 0, 1}, -0.5},
          kTorus};
}

Pose moved(Pose pose, const Eigen::Vector3d& by) {
  pose.translation() += by;
  return pose;
}

TEST(Law13Shapes, EveryPairIsSoundBesideSamples) {
  RandomSource source(1340);
  const std::vector<Shape> shapes = all_kinds();
  int later = 0, none = 0;
  for (std::size_t i = 0; i < 4 * shapes.size() * shapes.size(); ++i) {
    const Shape &a = shapes[i % shapes.size()], &b = shapes[i / shapes.size() % shapes.size()];
    if (a.kind() == ShapeKind::HalfSpace && b.kind() == ShapeKind::HalfSpace) continue;
    const Pose pose_a = tests::random_pose(0.5, source), pose_b = tests::random_pose(3, source);
    const Eigen::Vector3d d =
        source.uniform(0.5, 2) * (source.vector(-1, 1) - pose_b.translation());
    const auto gap = [&](double t) { return distance({a, pose_a}, {b, moved(pose_b, t * d)}); };
    const auto found = cast({a, pose_a}, {b, pose_b}, d);
    const double end = found ? found->time : 1;
    for (int k = 0; k < 40 && end > 0; ++k) {
      ASSERT_GT(gap(end * k / 40).distance, 0) << i << " at " << end * k / 40;
    }
    const auto mirrored = cast({b, pose_b}, {a, pose_a}, -d);
    ASSERT_EQ(mirrored.has_value(), found.has_value()) << i;
    if (!found) {
      ++none;
      continue;
    }
    EXPECT_EQ(found->is_at_start, intersects({a, pose_a}, {b, pose_b})) << i;
    EXPECT_LE(gap(found->time).distance, 1e-9) << i;
    EXPECT_NEAR(found->normal.norm(), 1, 1e-12) << i;
    EXPECT_EQ(mirrored->time, found->time) << i;
    EXPECT_EQ(mirrored->is_at_start, found->is_at_start) << i;
    if (found->is_at_start) continue;
    ++later;
    EXPECT_EQ(mirrored->normal, -found->normal) << i;
    EXPECT_LE(found->normal.dot(d), 0) << i;
    // The point is of both, where B has come to; a plane's is any that is nearest.
    const Shape speck = Sphere{found->point, 1e-7};
    EXPECT_TRUE(intersects({a, pose_a}, speck)) << i;
    const bool has_plane = a.kind() == ShapeKind::HalfSpace || b.kind() == ShapeKind::HalfSpace;
    if (!has_plane) {
      EXPECT_TRUE(intersects({b, moved(pose_b, found->time * d)}, speck)) << i;
    }
  }
  EXPECT_GT(later, 80);
  EXPECT_GT(none, 40);
}

TEST(Law13Shapes, TimesThatAreKnown) {
  const HalfSpace ground{{0, 0, 1}, 0};
  const auto near = [](const std::optional<ShapeCast>& cast, double time) {
    return cast && cast->time <= time && cast->time >= time - 1e-9;
  };
  for (const Shape& shape :
       {Shape(Capsule{0.25, 0.25}), Shape(Cylinder{1, 0.5}), Shape(Cone{1, 0.5}),
        Shape(Ellipsoid{{0, 0, 0}, {1, 2, 0.5}}), Shape(Box{{2, 3, 0.5}})}) {
    // Half a metre reaches down from two: the ground, and the top of a box and of a hull.
    const PlacedShape above{shape, tests::at(0, 0, 2)};
    EXPECT_TRUE(near(cast({ground}, above, {1, 0, -3}), 0.5));
    EXPECT_TRUE(near(cast(above, {ground}, {1, 0, 3}), 0.5));
    EXPECT_TRUE(near(cast({Box{{9, 9, 0.5}}, tests::at(0, 0, -0.5)}, above, {1, 0, -3}), 0.5));
    const ConvexHull slab(
        std::vector<Eigen::Vector3d>{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}, {0, 0, -1}});
    const auto landed = cast({slab}, above, {1, 0, -3});
    EXPECT_TRUE(near(landed, 0.5));
    EXPECT_NEAR(landed->normal.z(), 1, 1e-6);
    EXPECT_NEAR(landed->point.z(), 0, 1e-8);
    EXPECT_FALSE(cast({ground}, above, {1, 0, -1.49}));
    EXPECT_FALSE(cast({slab}, above, {1, 0, 3}));
  }
  // Two balls, three and four beside each other: their middles come as near as five.
  const auto balls =
      cast({Sphere{{0, 0, 0}, 2}}, {Sphere{{0, 0, 0}, 3}, tests::at(8, 3, 0)}, {-8, 0, 0});
  EXPECT_TRUE(near(balls, 0.5));
  EXPECT_NEAR(balls->normal.x(), 0.8, 1e-9);
  EXPECT_NEAR(balls->point.y(), 1.2, 1e-9);
  EXPECT_FALSE(cast({ground}, {HalfSpace{{0, 0, -1}, -2}}, {0, 0, -1.9}));
  EXPECT_TRUE(near(cast({ground}, {HalfSpace{{0, 0, -1}, -2}}, {0, 0, -4}), 0.5));
}

TEST(Law13Shapes, AreNotLateAndHardlyEarlyBesideExactCasts) {
  RandomSource source(1341);
  int later = 0;
  for (int n = 0; n < 60; ++n) {
    const PlacedMesh mesh{tests::random_soup({.count = 60, .size = 0.3}, source),
                          tests::random_pose(0.5, source)};
    Pose pose = tests::random_pose(0, source);
    pose.translation() = source.vector(-4, 4);
    const Eigen::Vector3d half = source.vector(0.05, 0.5);
    const Eigen::Vector3d d = source.uniform(0.5, 2) * (source.vector(-1, 1) - pose.translation());
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i < 8; ++i) {
      corners.emplace_back((i & 1) != 0 ? half[0] : -half[0], (i & 2) != 0 ? half[1] : -half[1],
                           (i & 4) != 0 ? half[2] : -half[2]);
    }
    const auto of_box = cast(PlacedMeshView(mesh), Obb{pose, half}, d);
    const auto of_hull = cast({Shape(mesh.mesh), mesh.pose}, {ConvexHull(corners), pose}, d);
    const auto of_ball = cast(PlacedMeshView(mesh), Sphere{pose.translation(), half[0]}, d);
    const auto of_capsule = cast({Shape(mesh.mesh), mesh.pose}, {Capsule{half[0], 0}, pose}, d);
    const auto expect_near = [&](const std::optional<VolumeCast>& exact,
                                 const std::optional<ShapeCast>& found) {
      ASSERT_EQ(found.has_value(), exact.has_value()) << n;
      if (!exact) return;
      EXPECT_LE(found->time, exact->time) << n;
      EXPECT_EQ(found->is_at_start, exact->is_at_start) << n;
      EXPECT_GE(found->time, exact->time - 1e-7) << n;
      if (exact->is_at_start) return;
      ++later;
      EXPECT_LE((found->point - exact->point).norm(), 1e-6) << n;
    };
    expect_near(of_box, of_hull);
    expect_near(of_ball, of_capsule);
  }
  EXPECT_GT(later, 40);
}

TEST(Law13Shapes, AskMeshesExactly) {
  const PlacedShape mesh{kTorus, tests::at(0.1, 0, 0)};
  const PlacedMesh exact{kTorus, tests::at(0.1, 0, 0)};
  const Eigen::Vector3d d(-4, 0.1, 0.2);
  const Pose pose = tests::at(3, 0, 0);
  const auto same = [](const auto& exact_cast, const std::optional<ShapeCast>& found) {
    return exact_cast && found &&
           *found == ShapeCast{exact_cast->time, exact_cast->is_at_start, exact_cast->point,
                               exact_cast->normal};
  };
  EXPECT_TRUE(
      same(cast(exact, PlacedMeshView(kTorus, pose), d), cast(mesh, {Shape(kTorus), pose}, d)));
  EXPECT_TRUE(same(cast(exact, Sphere{{3.5, 0, 0}, 0.25}, d),
                   cast(mesh, {Sphere{{0.5, 0, 0}, 0.25}, pose}, d)));
  EXPECT_TRUE(same(cast(exact, Obb{pose, {0.1, 0.2, 0.3}}, d),
                   cast(mesh, {Box{{0.1, 0.2, 0.3}}, pose}, d)));
  // The mesh goes, and has come there.
  const auto ball = cast({Sphere{{0.5, 0, 0}, 0.25}, pose}, mesh, -d);
  const auto mirrored = cast(exact, Sphere{{3.5, 0, 0}, 0.25}, d);
  EXPECT_EQ(ball->time, mirrored->time);
  EXPECT_EQ(ball->normal, -mirrored->normal);
  EXPECT_LE((ball->point - (mirrored->point - mirrored->time * d)).norm(), 1e-12);
}

TEST(Law13Shapes, WhatSlidesAlongGoesOnInFewSteps) {
  const Box floor{{20, 20, 1}};
  for (const Shape& shape : {Shape(Capsule{0.25, 0.25}), Shape(Cylinder{1, 0.5}),
                             Shape(Ellipsoid{{0, 0, 0}, {1, 2, 0.5}})}) {
    Work work;
    const PlacedShape on_it{shape, tests::at(-9, 0, 1.5 + 1e-9)};
    EXPECT_FALSE(cast({floor}, on_it, {18, 0, 0}, &work));
    EXPECT_FALSE(cast({floor}, on_it, {18, 0, 1e-3}, &work));
    EXPECT_LE(work.convex_tests, 8u);
  }
  Work work;
  RandomSource source(1342);
  const std::vector<Shape> shapes = all_kinds();
  int asked = 0;
  for (int n = 0; n < 300; ++n) {
    const Shape &a = shapes[static_cast<std::size_t>(n) % 7], &b = shapes[n / 7 % 7];
    const Pose pose_b = tests::random_pose(3, source);
    cast({a}, {b, pose_b}, 2 * (source.vector(-1, 1) - pose_b.translation()), &work);
    ++asked;
  }
  EXPECT_LE(work.convex_tests, 12u * static_cast<unsigned>(asked));
  EXPECT_EQ(work.convex_failures, 0u);
}

TEST(Law13Shapes, AtTheStartTheDeepestContactIsTold) {
  const auto met = cast({Box{{1, 1, 1}}}, {Capsule{0.5, 0.5}, tests::at(0, 0, 1.75)}, {0, 0, 1});
  ASSERT_TRUE(met);
  EXPECT_EQ(met->time, 0);
  EXPECT_TRUE(met->is_at_start);
  EXPECT_NEAR(met->normal.z(), 1, 1e-9);
  EXPECT_NEAR(met->point.z(), 1, 1e-9);
  const HalfSpace ground{{0, 0, 1}, 0};
  EXPECT_TRUE(cast({ground}, {ground}, {0, 0, 1})->is_at_start);
  EXPECT_TRUE(cast({ground}, {Shape(kTorus)}, {0, 0, 1})->is_at_start);
}

TEST(Law13Shapes, FarFromTheOriginTimesAreAsGood) {
  const Eigen::Vector3d far(1e8, -1e8, 1e8);
  const auto met = cast({Cylinder{1, 0.5}, tests::at(far.x(), far.y(), far.z())},
                        {Cone{1, 0.5}, tests::at(far.x(), far.y(), far.z() + 2)}, {0, 0, -2});
  ASSERT_TRUE(met);
  EXPECT_LE(met->time, 0.5);
  EXPECT_GE(met->time, 0.5 - 1e-9);
}

TEST(Law13Shapes, RefuseWhatIsNoDisplacement) {
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const double bad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(cast({ball}, {ball, tests::at(9)}, {0, bad, 0}), InputError);
  EXPECT_THROW(cast({ball}, {ball, tests::at(9)}, {0, 1e101, 0}), PoseError);
  Pose skewed = Pose::Identity();
  skewed.linear() *= 2;
  EXPECT_THROW(cast({ball, skewed}, {ball, tests::at(9)}, {0, 1, 0}), PoseError);
  EXPECT_THROW(cast({ball}, {ball, skewed}, {0, 1, 0}), PoseError);
}

}  // namespace
}  // namespace graze
