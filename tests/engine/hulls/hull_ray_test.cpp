// Rays at hulls of every thinness beside the hull by its definition, in rational numbers.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/engine/hulls/hull_sets.h"
#include "tests/engine/hulls/rational_hull.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::HullSet;
using tests::RationalHull;
using tests::RationalPoint;

constexpr double kRayTolerance = 0x1p-40;  // law 11

struct PlacedHull {
  std::vector<Vector3d> points;
  Pose pose;
  Shape shape;
  RationalHull truth;
  Vector3d middle;
  double size;      // no point is further from the middle
  double rounding;  // of where the middle comes to lie
};

/// None if the points have no volume, which the library must find, too.
std::optional<PlacedHull> placed_hull(const std::vector<Vector3d>& points, const Pose& pose) {
  std::vector<RationalPoint> placed;
  for (const Vector3d& p : points)
    placed.push_back(tests::placed(pose, p));
  RationalHull truth(std::move(placed));
  if (truth.facets().empty()) {
    EXPECT_THROW(ConvexHull{points}, InputError);
    return std::nullopt;
  }
  Vector3d low = points[0], high = points[0];
  for (const Vector3d& p : points)
    low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Vector3d middle = low * 0.5 + high * 0.5;
  const double moved = middle.cwiseAbs().maxCoeff() + pose.translation().cwiseAbs().maxCoeff();
  return PlacedHull{points,
                    pose,
                    ConvexHull(points),
                    std::move(truth),
                    place(pose, middle),
                    (high - low).norm() / 2,
                    0x10p-53 * moved};
}

/// The hit is that of a ray that is moved by no more than law 11 says, and so is a miss.
void expect_as_moved(const PlacedHull& hull, const Ray& ray) {
  const auto hit = cast_ray({hull.shape, hull.pose}, ray);
  const double away = (ray.origin - hull.middle).norm();
  const double tolerance = kRayTolerance * (hull.size + away) + hull.rounding;
  const RationalPoint origin = tests::rational(ray.origin);
  const double outside = hull.truth.distance(origin);
  if (hit && hit->distance == 0) {
    EXPECT_LE(outside, tolerance);
    return;
  }
  if (hit) {
    // On a face that looks towards the ray.
    const RationalPoint point = tests::rational(hit->point);
    double nearest = HUGE_VAL, off = HUGE_VAL;
    const Vector3d unit = ray.direction.normalized();
    for (const RationalHull::Facet& facet : hull.truth.facets()) {
      if (facet.unit_normal.dot(unit) > 1e-15) continue;
      const double distance = hull.truth.distance(facet, point);
      nearest = std::min(nearest, distance);
      if (distance <= tolerance)
        off = std::min(off, (facet.unit_normal - hit->normal).cwiseAbs().maxCoeff());
    }
    EXPECT_LE(nearest, tolerance);
    EXPECT_LE(off, 1e-12);
    EXPECT_LE((hit->point - (ray.origin + unit * hit->distance)).norm(), tolerance);
    if (outside == 0) {
      EXPECT_LE(hull.truth.distance_to_boundary(origin), tolerance);
    }
    return;
  }
  if (outside == 0) {
    EXPECT_LE(hull.truth.distance_to_boundary(origin), tolerance);
    return;
  }
  const tests::LinePassage line = tests::pass(hull.truth, ray.origin, ray.direction);
  if (line.is_hit && line.enter > 0 && outside > tolerance) {
    EXPECT_LE(line.margin, tolerance);
  }
}

/// Also: what law 11 lets nobody hit.
void expect_right(const PlacedHull& hull, const Ray& ray) {
  expect_as_moved(hull, ray);
  const double away = (ray.origin - hull.middle).norm();
  const double tolerance = kRayTolerance * (hull.size + away) + hull.rounding;
  const tests::LinePassage line = tests::pass(hull.truth, ray.origin, ray.direction);
  const double outside = hull.truth.distance(tests::rational(ray.origin));
  const bool is_beside = !line.is_hit && line.margin > tolerance;
  const bool is_behind = line.is_hit && line.exit < 0 && outside > tolerance;
  if (is_beside || is_behind) {
    EXPECT_FALSE(cast_ray({hull.shape, hull.pose}, ray)) << line.margin << " of " << tolerance;
  }
}

Vector3d within(const PlacedHull& hull, RandomSource& source) {
  Vector3d sum = Vector3d::Zero();
  double weights = 0;
  for (const Vector3d& p : hull.points) {
    const double weight = std::pow(source.uniform(0, 1), 4);
    sum += place(hull.pose, p) * weight;
    weights += weight;
  }
  return sum / weights;
}

/// A point of an edge, a corner, or somewhere inside, off by from none to much.
Vector3d target(const PlacedHull& hull, RandomSource& source) {
  const auto any = [&] {
    return place(hull.pose, hull.points[static_cast<std::size_t>(
                                source.integer(0, static_cast<int>(hull.points.size()) - 1))]);
  };
  Vector3d at = within(hull, source);
  const double which = source.integer(0, 3);
  if (which == 0) at = any();
  if (which == 1) at = any() * 0.5 + any() * 0.5;
  if (which < 3) {
    at += source.vector(-1, 1) * (hull.size * std::pow(10.0, source.uniform(-14, 0)));
  }
  return at;
}

Ray random_ray(const PlacedHull& hull, RandomSource& source) {
  const Vector3d at = target(hull, source);
  Vector3d direction = source.vector(-1, 1);
  const double which = source.integer(0, 5);
  if (which == 0) direction = Vector3d::Unit(static_cast<int>(source.integer(0, 2)));
  if (which == 1) direction = hull.pose.linear().col(static_cast<int>(source.integer(0, 2)));
  if (which == 2) direction = target(hull, source) - at;  // along faces, or nearly
  if (source.integer(0, 1) == 0) direction = -direction;
  if (direction.isZero()) direction = Vector3d::UnitX();
  direction.normalize();
  const double before = source.integer(0, 9) == 0   ? 0
                        : source.integer(0, 9) == 0 ? 1e6
                                                    : source.uniform(-0.5, 4);
  return {at - direction * (before * hull.size), direction};
}

void try_rays(const std::vector<Vector3d>& points, const Pose& pose, int rays,
              RandomSource& source) {
  const auto hull = placed_hull(points, pose);
  if (!hull) return;
  const auto* built = hull->shape.as<ConvexHull>();
  EXPECT_EQ(built->vertex_count(), hull->truth.corners().size());
  for (int i = 0; i < rays && !testing::Test::HasFailure(); ++i) {
    const Ray ray = random_ray(*hull, source);
    SCOPED_TRACE(testing::Message() << "ray " << i << " from " << ray.origin.transpose()
                                    << " along " << ray.direction.transpose());
    expect_right(*hull, ray);
  }
}

void try_sets(int count, std::uint64_t seed) {
  RandomSource source(seed);
  for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
    const auto set = static_cast<HullSet>(n % tests::kHullSets);
    const double t = tests::random_thinness(source);
    SCOPED_TRACE(testing::Message() << "hull " << n << ", thinness " << t);
    std::vector<Vector3d> points = tests::hull_points(set, t, source);
    const bool is_turned = source.integer(0, 2) == 0;
    if (is_turned) tests::turn(points, source);
    const double scale = source.integer(0, 3) == 0 ? std::exp2(source.integer(-250, 250)) : 1;
    const double shift = source.integer(0, 3) == 0 ? 10 * scale : 0;
    tests::move(points, scale, source.vector(-shift, shift));
    Pose pose = Pose::Identity();
    if (source.integer(0, 2) == 0) pose = tests::random_pose(3 * scale, source);
    try_rays(points, pose, 12, source);
  }
}

TEST(HullRay, IsTheDefinitionsWhateverTheThinness) {
  try_sets(120, 1);
}

TEST(HullRaySlow, IsTheDefinitionsWhateverTheThinness) {
  try_sets(6000, 2);
}

TEST(HullRay, ARaisedCentreIsMetWhereItIs) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  points.emplace_back(0, 0, 1 + 5e-6);
  const ConvexHull hull(points);
  const auto above = [&](double x, double z_of_ray) {
    return cast_ray({hull, Pose::Identity()}, {{x, -3, z_of_ray}, {0, 1, 0}});
  };
  const auto down = [&](double x, double y) {
    const auto hit = cast_ray({hull, Pose::Identity()}, {{x, y, 3}, {0, 0, -1}});
    return hit ? hit->point.z() : -HUGE_VAL;
  };
  EXPECT_NEAR(down(0, 0), 1 + 5e-6, 1e-12);
  EXPECT_NEAR(down(0.5, 0.1), 1 + 2.5e-6, 1e-12);
  EXPECT_NEAR(down(0.9, 0.9), 1 + 0.5e-6, 1e-12);
  EXPECT_FALSE(above(0.9, 1 + 4e-6));
  EXPECT_TRUE(above(0, 1 + 4e-6));
  EXPECT_FALSE(above(0, 1 + 6e-6));
}

TEST(HullRay, SlabsOfSixteenPointsAreNotWider) {
  for (const double t : {1e-3, 1e-5, 1e-6, 1e-9, 1e-12, 1e-15, 1e-40, 1e-200}) {
    SCOPED_TRACE(t);
    RandomSource source(16);
    std::vector<Vector3d> points;
    for (int i = 0; i < 16; ++i)
      points.push_back(source.vector(-1, 1).cwiseProduct(Vector3d(1, 1, t)));
    const auto hull = placed_hull(points, Pose::Identity());
    ASSERT_TRUE(hull);
    for (int i = 0; i < 20; ++i) {
      const Vector3d at = source.vector(-3, 3);
      expect_right(*hull, {{at.x(), at.y(), 1}, {0, 0, -1}});
    }
  }
}

/// Where nothing is rounded before the hull is asked, there is no tolerance either.
TEST(HullRay, ARayThatBeginsInAHullDoesSoHoweverThin) {
  RandomSource source(6);
  int inside = 0, outside = 0;
  for (int n = 0; n < 60; ++n) {
    std::vector<Vector3d> points = tests::hull_points(n % 2 == 0 ? HullSet::Slab : HullSet::Needle,
                                                      tests::random_thinness(source), source);
    points.resize(std::min<std::size_t>(points.size(), 5));
    if (n % 3 == 0) tests::turn(points, source);
    for (std::size_t i = points.size(); i-- > 0;)
      points.push_back(-points[i]);  // so that the middle is 0
    const auto hull = placed_hull(points, Pose::Identity());
    if (!hull) continue;
    for (int i = 0; i < 20; ++i) {
      const auto any = [&] {
        return points[static_cast<std::size_t>(
            source.integer(0, static_cast<int>(points.size()) - 1))];
      };
      const double share = source.uniform(0, 1);
      Vector3d origin = any() * share + any() * (1 - share);
      if (i == 0) origin.setZero();
      if (i % 4 == 1) origin = any();
      const bool is_in = hull->truth.holds(tests::rational(origin));
      const auto hit = cast_ray({hull->shape, hull->pose}, {origin, source.vector(-1, 1)});
      if (is_in) {  // one that begins outside may be at a distance that rounds to 0
        EXPECT_TRUE(hit && hit->distance == 0) << n << " " << i;
      }
      (is_in ? inside : outside)++;
    }
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 100);
}

TEST(HullRay, AWorldSaysTheSame) {
  RandomSource source(5);
  for (int n = 0; n < 40; ++n) {
    const auto set = static_cast<HullSet>(n % tests::kHullSets);
    std::vector<Vector3d> points = tests::hull_points(set, tests::random_thinness(source), source);
    const Pose pose = tests::random_pose(1, source);
    const auto hull = placed_hull(points, pose);
    if (!hull) continue;
    World world;
    world.add({hull->shape, pose});
    world.update();
    for (int i = 0; i < 20; ++i) {
      const Ray ray = random_ray(*hull, source);
      const auto alone = cast_ray({hull->shape, pose}, ray);
      const auto seen = world.cast_ray(ray);
      ASSERT_EQ(seen.has_value(), alone.has_value()) << n << " " << i;
      if (seen) {
        EXPECT_EQ(seen->hit.distance, alone->distance);
      }
    }
  }
}

TEST(Law10Shape, HullsBelowTheSmallestLengthAreRefused) {
  const auto refusal = [](double scale) -> std::string {
    std::vector<Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tests::move(points, scale, Vector3d::Zero());
    try {
      const ConvexHull hull(points);
    } catch (const InputError& error) {
      return error.what();
    }
    return "taken";
  };
  EXPECT_EQ(refusal(2e-100), "taken");
  EXPECT_EQ(refusal(9e99), "taken");
  EXPECT_EQ(refusal(1e-101), "convex hull: its longest side is below the smallest length");
  EXPECT_EQ(refusal(1e-320), "convex hull: its longest side is below the smallest length");
}

}  // namespace
}  // namespace graze
