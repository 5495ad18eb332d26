// Gaps that a formula proves: no motion of that length brings two shapes together.

#include <graze/engine/world/bodies/body_motion.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

struct Placed {
  std::shared_ptr<const BodyShape> body;
  Pose pose;

  const Shape& shape() const { return *body->shape(); }
};

bool meet(const Placed& a, const Placed& b) {
  return intersects({a.shape(), a.pose}, {b.shape(), b.pose});
}

/// Turned about its origin at random and pushed along a direction, so that its path is that long or
/// a little less.
Placed moved(const Placed& from, const Eigen::Vector3d& way, double path, RandomSource& source) {
  const double push = path * (source.integer(0, 2) == 0 ? 1 : source.uniform(0, 1));
  const double radius = from.body->bounding_radius();
  Placed to = from;
  to.pose.translation() += way * push;
  const double angle = (path - push) / (std::sqrt(2) * radius);
  const Eigen::Vector3d axis = source.vector(-1, 1).normalized();
  to.pose.linear() =
      Eigen::AngleAxisd(angle, axis).toRotationMatrix() * Eigen::Matrix3d(from.pose.linear());
  EXPECT_LE(motion_bound(from.pose, to.pose, radius), path * (1 + 9e-7) + 1e-12);
  return to;
}

struct Counts {
  int apart = 0, with_gap = 0, most_of_it = 0;
};

/// Puts pairs of the kinds beside each other and moves them by their gaps.
Counts count_pairs(const Shape& shape_a, const Shape& shape_b, RandomSource& source) {
  Counts counts;
  const auto body_a = share(shape_a), body_b = share(shape_b);
  for (int n = 0; n < 40; ++n) {
    const bool is_distorted = n % 4 == 0;
    const auto pose = [&](double radius) {
      const Pose at = tests::random_pose(radius, source);
      return is_distorted ? tests::distorted(at, 3e-7, source) : at;
    };
    const Placed a{body_a, pose(0.5)}, b{body_b, pose(2)};
    if (meet(a, b)) continue;
    const ShapeDistance distance = graze::distance({a.shape(), a.pose}, {b.shape(), b.pose});
    const double gap = body_a->gap(a.pose, *body_b, b.pose);
    EXPECT_EQ(gap, body_b->gap(b.pose, *body_a, a.pose));
    EXPECT_LE(gap, distance.distance);
    ++counts.apart;
    counts.with_gap += gap > 0;
    counts.most_of_it += gap > 0.9 * distance.distance;
    for (int i = 0; i < 20; ++i) {
      const double of_a = gap * source.uniform(0, 1);
      const Placed now_a = moved(a, distance.normal, of_a * (1 - 1e-6), source);
      const Placed now_b = moved(b, -distance.normal, (gap - of_a) * (1 - 1e-6), source);
      EXPECT_FALSE(gap > 0 && meet(now_a, now_b));
    }
  }
  return counts;
}

Counts count_kinds(ShapeKind kind_a, ShapeKind kind_b) {
  RandomSource source(7);
  Counts sum;
  for (int i = 0; i < 20; ++i) {
    const Shape a = tests::random_shape(kind_a, 0.5, source);
    const Counts counts = count_pairs(a, tests::random_shape(kind_b, 0.5, source), source);
    sum.apart += counts.apart, sum.with_gap += counts.with_gap;
    sum.most_of_it += counts.most_of_it;
  }
  return sum;
}

TEST(QuickGap, IsMostOfTheDistanceOfBalls) {
  const Counts balls = count_kinds(ShapeKind::Sphere, ShapeKind::Sphere);
  const Counts mixed = count_kinds(ShapeKind::Sphere, ShapeKind::Box);
  EXPECT_GT(balls.apart, 300);
  EXPECT_GT(balls.most_of_it, 0.95 * balls.apart);
  EXPECT_GT(mixed.apart, 300);
  EXPECT_GT(mixed.most_of_it, 0.95 * mixed.apart);
}

TEST(QuickGap, IsProvedForMostBoxes) {
  const Counts boxes = count_kinds(ShapeKind::Box, ShapeKind::Box);
  EXPECT_GT(boxes.apart, 300);
  EXPECT_GT(boxes.with_gap, 0.8 * boxes.apart);
}

TEST(QuickGap, IsProvedBesideMeshes) {
  RandomSource source(9);
  Counts sum;
  for (int i = 0; i < 20; ++i) {
    const Mesh mesh = i % 2 == 0 ? tests::make_sphere(1, 8, 12) : tests::random_soup({}, source);
    const ShapeKind kind = i % 4 < 2 ? ShapeKind::Sphere : ShapeKind::Box;
    const Counts counts = count_pairs(mesh, tests::random_shape(kind, 0.3, source), source);
    sum.apart += counts.apart, sum.with_gap += counts.with_gap;
    sum.most_of_it += counts.most_of_it;
  }
  EXPECT_GT(sum.apart, 300);
  EXPECT_GT(sum.with_gap, 0.9 * sum.apart);
  EXPECT_GT(sum.most_of_it, 0.3 * sum.apart);
}

TEST(QuickGap, IsNoneForShapesThatMeet) {
  RandomSource source(11);
  for (const ShapeKind a : {ShapeKind::Sphere, ShapeKind::Box}) {
    for (const ShapeKind b : {ShapeKind::Sphere, ShapeKind::Box}) {
      const auto body_a = share(tests::random_shape(a, 1, source));
      const auto body_b = share(tests::random_shape(b, 1, source));
      const Pose pose = tests::random_pose(0.1, source);
      EXPECT_EQ(body_a->gap(pose, *body_b, tests::random_pose(0.1, source)), 0);
    }
  }
}

}  // namespace
}  // namespace graze
