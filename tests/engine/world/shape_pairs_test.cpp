// Every pair of kinds. Answers carry their own proof: a distance is right if its points lie in the
// shapes and two planes that support them are as far apart; a hit is right if some point lies in
// both.

#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/narrowphase/triangle_distance.h>
#include <gtest/gtest.h>

#include <algorithm>
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
using tests::outside_by;
using tests::random_pose;
using tests::random_shape;
using tests::reach_along;
using tests::size_of;

Pose at(const Vector3d& translation) {
  Pose pose = Pose::Identity();
  pose.translation() = translation;
  return pose;
}

struct Placed {
  Shape shape;
  Pose pose;
};

bool is_mesh(const Placed& p) {
  return p.shape.kind() == ShapeKind::Mesh;
}

double scale_of(const Placed& a, const Placed& b) {
  return size_of(a.shape) + size_of(b.shape) + (a.pose.translation() - b.pose.translation()).norm();
}

/// What is demanded beyond proof. Shapes of very different sizes make flat simplices, for which a
/// search may end before its bounds meet; it must then say so.
struct Demand {
  double relative_gap = kTouchTolerance;  ///< of the two bounds, to the scale
  PairStatus worst = PairStatus::Converged;
};

/// Returns whether the two intersect.
bool expect_proved(const Placed& a, const Placed& b, const std::string& label,
                   const Demand& demand = {}) {
  Work work;
  const ShapeDistance found = distance({a.shape, a.pose}, {b.shape, b.pose}, &work);
  const bool is_hit = intersects({a.shape, a.pose}, {b.shape, b.pose});
  EXPECT_EQ(is_hit, found.distance == 0) << label;
  EXPECT_LE(found.status, demand.worst) << label;
  EXPECT_EQ(work.convex_failures > 0, found.status == PairStatus::NotConverged) << label;

  const ShapeDistance mirrored = distance({b.shape, b.pose}, {a.shape, a.pose});
  EXPECT_EQ(mirrored.distance, found.distance) << label;
  EXPECT_EQ(mirrored.point_a, found.point_b) << label;
  EXPECT_EQ(mirrored.point_b, found.point_a) << label;
  EXPECT_EQ(intersects({b.shape, b.pose}, {a.shape, a.pose}), is_hit) << label;

  const double scale = scale_of(a, b);
  const double reach = a.pose.translation().norm() + b.pose.translation().norm();
  const double rounding = 1e-14 * scale + 1e-15 * reach;
  const double tolerance = demand.relative_gap * scale + 4 * rounding;
  EXPECT_LE(outside_by(a.shape, a.pose, found.point_a), tolerance) << label;
  EXPECT_LE(outside_by(b.shape, b.pose, found.point_b), tolerance) << label;
  EXPECT_NEAR((found.point_b - found.point_a).norm(), found.distance, tolerance) << label;
  EXPECT_LE(found.lower_bound, found.distance) << label;
  if (found.distance < 1e-6 * scale || is_mesh(a) || is_mesh(b)) return is_hit;
  EXPECT_GE(found.lower_bound, found.distance - tolerance) << label;
  const Vector3d n = found.normal;
  EXPECT_NEAR(n.norm(), 1, 1e-15) << label;
  const double gap = -reach_along(b.shape, b.pose, -n) - reach_along(a.shape, a.pose, n);
  if (std::isfinite(gap)) {
    EXPECT_GE(gap, found.lower_bound - 4 * rounding) << label;
  }
  return is_hit;
}

TEST(ShapePairs, EveryPairOfKindsProvesItsAnswers) {
  RandomSource source(11);
  for (const ShapeKind kind_a : tests::kOwnKinds) {
    for (const ShapeKind kind_b : tests::kOwnKinds) {
      if (kind_b < kind_a) continue;
      int hits = 0;
      constexpr int kPoses = 120;
      for (int n = 0; n < kPoses; ++n) {
        const Placed a{random_shape(kind_a, 1, source), random_pose(n % 4 == 0 ? 1e6 : 1, source)};
        Placed b{random_shape(kind_b, 1, source), random_pose(1, source)};
        const double away = source.uniform(0, 1) * (size_of(a.shape) + size_of(b.shape));
        b.pose.translation() = a.pose.translation() + source.vector(-1, 1).normalized() * away;
        hits += expect_proved(
            a, b, std::string(name_of(kind_a)) + "/" + name_of(kind_b) + " " + std::to_string(n));
        if (HasFailure()) return;
      }
      EXPECT_GT(hits, 0) << name_of(kind_a) << "/" << name_of(kind_b);
      const bool are_planes = kind_a == ShapeKind::HalfSpace && kind_b == kind_a;
      EXPECT_EQ(hits == kPoses, are_planes) << name_of(kind_a) << "/" << name_of(kind_b);
    }
  }
}

// Thin, tiny and huge shapes in one pair, and identity rotations, where simplices are flat.
TEST(ShapePairs, SizesOverTwelveDecadesAndFlatShapes) {
  RandomSource source(12);
  std::uint64_t failures = 0;
  for (int n = 0; n < 1500; ++n) {
    const ShapeKind kind_a = tests::kOwnKinds[static_cast<std::size_t>(source.integer(0, 6))];
    const ShapeKind kind_b = tests::kOwnKinds[static_cast<std::size_t>(source.integer(0, 6))];
    const double size_a = std::pow(10.0, source.integer(-6, 6));
    const double size_b = std::pow(10.0, source.integer(-6, 6));
    Placed a{random_shape(kind_a, size_a, source), random_pose(1, source)};
    Placed b{random_shape(kind_b, size_b, source), random_pose(1, source)};
    if (n % 3 == 0) a.pose = b.pose = Pose::Identity();
    if (n % 5 == 0) a.shape = Cylinder{size_a, 1e-9 * size_a};
    if (n % 7 == 0) b.shape = Box{{size_b, 1e-8 * size_b, size_b}};
    const double away = source.uniform(0, 1.2) * (size_of(a.shape) + size_of(b.shape));
    const Vector3d direction = n % 2 == 0 ? Vector3d(0, 0, 1) : source.vector(-1, 1).normalized();
    b.pose.translation() = a.pose.translation() + direction * away;
    Work work;
    distance({a.shape, a.pose}, {b.shape, b.pose}, &work);
    failures += work.convex_failures;
    expect_proved(a, b,
                  std::string(name_of(a.shape.kind())) + "/" + name_of(b.shape.kind()) + " " +
                      std::to_string(n),
                  {.relative_gap = 1e-7, .worst = PairStatus::NotConverged});
    if (HasFailure()) return;
  }
  EXPECT_LT(failures, 30u);  // of 1500
}

TEST(ShapePairs, ContainmentAndCoincidenceAreHits) {
  RandomSource source(13);
  for (const ShapeKind kind_a : tests::kOwnKinds) {
    for (const ShapeKind kind_b : tests::kOwnKinds) {
      if (kind_a == ShapeKind::Mesh || kind_b == ShapeKind::Mesh) continue;
      const Shape a = random_shape(kind_a, 1, source);
      const Shape small = random_shape(kind_b, 1e-3, source);
      const Pose pose = random_pose(1, source);
      const Pose inner = kind_a == ShapeKind::HalfSpace
                             ? at(pose.translation() - pose.linear() * a.as<HalfSpace>()->normal)
                             : pose;
      // A sphere's and an ellipsoid's centre, and a hull's middle, are not at the origin, but near.
      if (kind_a == ShapeKind::ConvexHull) continue;
      EXPECT_TRUE(intersects({a, pose}, {small, inner}))
          << name_of(kind_a) << "/" << name_of(kind_b);
      EXPECT_TRUE(intersects({a, pose}, {a, pose})) << name_of(kind_a);
    }
  }
}

TEST(Law11Shapes, SpheresAndBoxesTouchExactly) {
  const Sphere unit{{0, 0, 0}, 1};
  const double inside = 2;
  const double outside = std::nextafter(2.0, 3.0);
  EXPECT_TRUE(intersects({unit, at({0, 0, 0})}, {unit, at({inside, 0, 0})}));
  EXPECT_FALSE(intersects({unit, at({0, 0, 0})}, {unit, at({outside, 0, 0})}));
  EXPECT_GT(distance({unit, at({0, 0, 0})}, {unit, at({outside, 0, 0})}).distance, 0);
  EXPECT_EQ(distance({unit, at({0, 0, 0})}, {unit, at({inside, 0, 0})}).distance, 0);
  const Box box{{1, 1, 1}};
  EXPECT_TRUE(intersects({unit, at({0, 0, 0})}, {box, at({0.5, inside, 0})}));
  EXPECT_FALSE(intersects({unit, at({0, 0, 0})}, {box, at({0.5, outside, 0})}));
  EXPECT_GT(distance({unit, at({0, 0, 0})}, {box, at({0.5, outside, 0})}).distance, 0);
  const Mesh mesh = tests::make_box({1, 1, 1});
  EXPECT_TRUE(intersects({unit, at({0, 0, 0})}, {mesh, at({0.5, inside, 0})}));
  EXPECT_FALSE(intersects({unit, at({0, 0, 0})}, {mesh, at({0.5, outside, 0})}));
  EXPECT_TRUE(intersects({box, at({0, 0, 0})}, {mesh, at({0.5, inside, 0})}));
  EXPECT_FALSE(intersects({box, at({0, 0, 0})}, {mesh, at({0.5, outside, 0})}));
  EXPECT_TRUE(intersects({mesh, at({0, 0, 0})}, {mesh, at({0.5, inside, 0})}));
  EXPECT_FALSE(intersects({mesh, at({0, 0, 0})}, {mesh, at({0.5, outside, 0})}));
}

// Pairs of every other convex kind, that touch along z by construction: apart is sure as soon as it
// is beyond the tolerance, and never said of shapes that touch.
TEST(Law11Shapes, OthersTouchWithinTheTolerance) {
  const std::vector<Vector3d> corners{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                      {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
  const std::vector<Shape> shapes{Sphere{{0, 0, 0}, 1}, Box{{1, 1, 1}},
                                  Capsule{0.25, 0.75},  Cylinder{0.5, 1},
                                  Cone{0.5, 1},         Ellipsoid{{0, 0, 0}, {0.5, 2, 1}},
                                  ConvexHull(corners)};
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      for (const double y : {0.0, 1e-3}) {
        const bool is_round = a.kind() == ShapeKind::Sphere || a.kind() == ShapeKind::Ellipsoid ||
                              b.kind() == ShapeKind::Sphere || b.kind() == ShapeKind::Ellipsoid;
        if (y > 0 && is_round) continue;
        const std::string label = std::string(name_of(a.kind())) + "/" + name_of(b.kind());
        EXPECT_TRUE(intersects({a, at({0, 0, 0})}, {b, at({0, 0, 2 - 1e-12})})) << label;
        EXPECT_FALSE(intersects({a, at({0, 0, 0})}, {b, at({0, 0, 2 + 1e-9})})) << label;
        EXPECT_NEAR(distance({a, at({0, 0, 0})}, {b, at({0, 0, 2.5})}).distance, 0.5, 1e-12)
            << label;
      }
    }
  }
}

// Axes cross at a third of their length, or pass there at a known distance, at all angles and
// sizes: a bound of the distance holds however badly the crossing is known.
TEST(Law11Shapes, ThinCapsulesThatCrossAreHits) {
  const Eigen::Matrix3d turn = Eigen::Quaterniond(1, 2, 3, 4).normalized().toRotationMatrix();
  Pose own = Pose::Identity();
  own.linear() = turn;
  for (const double length : {1e-85, 1e-3, 1.0, 1e90}) {
    const double radius = 0x1p-36 * length;
    const Shape rod = Capsule{radius, length};
    for (double sine = 0.5; sine > 0x1p-56; sine *= 0.71) {
      const double cosine = std::sqrt(1 - sine * sine);
      Eigen::Matrix3d across;
      across << 1, 0, 0, 0, cosine, -sine, 0, sine, cosine;
      Pose pose = Pose::Identity();
      pose.linear() = turn * across;
      for (double way = 0; way < 0.1; way = way == 0 ? 0x1p-35 : 16 * way) {
        pose.translation() = turn * Vector3d(way, -0.2 * sine, 0.3 + 0.2 * cosine) * length;
        EXPECT_EQ(intersects({rod, own}, {rod, pose}), way <= 0x1p-35)
            << length << " " << sine << " " << way;
        const ShapeDistance found = distance({rod, own}, {rod, pose});
        EXPECT_LE(found.lower_bound, std::max(way - 0x1p-35 + 0x1p-50, 0.0) * length) << sine;
        EXPECT_NEAR(found.distance / length, std::max(way - 0x1p-35, 0.0), 0x1p-44) << sine;
      }
    }
  }
}

TEST(ShapePairs, RigidMotionsOfBothChangeNothingButRounding) {
  RandomSource source(14);
  for (int n = 0; n < 1000; ++n) {
    const Shape a =
        random_shape(tests::kOwnKinds[static_cast<std::size_t>(source.integer(0, 8))], 1, source);
    const Shape b =
        random_shape(tests::kOwnKinds[static_cast<std::size_t>(source.integer(0, 8))], 1, source);
    if (a.kind() == ShapeKind::HalfSpace && b.kind() == ShapeKind::HalfSpace) continue;
    const Pose pose_a = random_pose(1, source), pose_b = random_pose(1, source);
    const Pose motion = random_pose(10, source);
    const double before = distance({a, pose_a}, {b, pose_b}).distance;
    const double after = distance({a, motion * pose_a}, {b, motion * pose_b}).distance;
    ASSERT_NEAR(before, after, 1e-11) << name_of(a.kind()) << "/" << name_of(b.kind()) << n;
  }
}

TEST(ShapePairs, ParallelHalfSpaces) {
  const HalfSpace below{{0, 0, 1}, 0};
  const HalfSpace above{{0, 0, -1}, -1};
  EXPECT_FALSE(intersects({below, at({0, 0, 0})}, {above, at({0, 0, 0})}));
  EXPECT_NEAR(distance({below, at({0, 0, 0})}, {above, at({5, 0, 0})}).distance, 1, 1e-14);
  EXPECT_TRUE(intersects({below, at({0, 0, 0})}, {above, at({0, 0, -1})}));
  EXPECT_TRUE(intersects({below, at({0, 0, 0})}, {HalfSpace{{0, 1e-9, -1}, -1}, at({0, 0, 0})}));
}

/// The least distance of the shape to any triangle, each asked by itself.
double brute_force(const Placed& other, const Placed& mesh) {
  double least = std::numeric_limits<double>::infinity();
  const Mesh& triangles = *mesh.shape.as<Mesh>();
  for (std::size_t i = 0; i < triangles.triangles().size(); ++i) {
    const Triangle t = triangles.triangle(i);
    const Mesh one(std::vector<Vector3d>{t.a, t.b, t.c}, std::vector<TriangleIndices>{{0, 1, 2}});
    least = std::min(least, distance({other.shape, other.pose}, {one, mesh.pose}).distance);
  }
  return least;
}

TEST(Law9Shapes, MeshPairsAreBruteForceOverTriangles) {
  RandomSource source(15);
  for (const ShapeKind kind : tests::kOwnKinds) {
    for (int n = 0; n < 12; ++n) {
      const Placed other{random_shape(kind, 0.6, source), random_pose(2, source)};
      Placed mesh{random_shape(ShapeKind::Mesh, 1.5, source), random_pose(1, source)};
      if (n % 4 == 3) mesh.pose = tests::distorted(mesh.pose, 0.9e-6, source);
      const double expected = brute_force(other, mesh);
      const double found = distance({other.shape, other.pose}, {mesh.shape, mesh.pose}).distance;
      // The same triangle is asked in both: only which one could differ, by rounding.
      ASSERT_NEAR(found, expected, 1e-13) << name_of(kind) << n;
      ASSERT_EQ(intersects({mesh.shape, mesh.pose}, {other.shape, other.pose}), expected == 0)
          << name_of(kind) << n;
    }
  }
}

TEST(ShapePairs, TheTableIsSymmetricAndRefusesStrangers) {
  for (const ShapeKind a : kShapeKinds) {
    for (const ShapeKind b : kShapeKinds)
      EXPECT_EQ(pair_method(a, b), pair_method(b, a));
  }
  EXPECT_THROW(pair_method(ShapeKind::Box, static_cast<ShapeKind>(kShapeKinds.size())), InputError);
}

}  // namespace
}  // namespace graze
