// The shortest way out of each other of two convex shapes: both bounds hold for every direction
// that is tried, and are what axes and formulas say where these know it.

#include <graze/engine/compare/judge/bodies/least_parting.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze::compare {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance = 1e-6;
constexpr double kRounding = 1e-12;

Pose turned(RandomSource& random, const Vector3d& at) {
  const Eigen::Quaterniond q{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                             random.uniform(-1, 1)};
  Pose pose = Pose::Identity();
  pose.linear() = q.normalized().toRotationMatrix();
  pose.translation() = at;
  return pose;
}

Vector3d near_by(RandomSource& random) {
  return {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
}

double way_along(const PlacedBody& a, const PlacedBody& b, const Vector3d& n) {
  return support_along(a.shape, a.pose, n) + support_along(b.shape, b.pose, -n);
}

/// Evenly over the sphere.
std::vector<Vector3d> many_directions(int count) {
  std::vector<Vector3d> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = 2.399963229728653 * i;
    const double flat = std::sqrt(1 - z * z);
    all.emplace_back(flat * std::cos(angle), flat * std::sin(angle), z);
  }
  return all;
}

/// The two halves of the separating axes: of two boxes no other direction is shorter.
double shortest_by_axes(const PlacedBody& a, const PlacedBody& b) {
  std::vector<Vector3d> axes;
  for (int i = 0; i < 3; ++i) {
    axes.push_back(a.pose.linear().col(i));
    axes.push_back(b.pose.linear().col(i));
    for (int j = 0; j < 3; ++j)
      axes.push_back(a.pose.linear().col(i).cross(b.pose.linear().col(j)).normalized());
  }
  double shortest = std::numeric_limits<double>::infinity();
  for (const Vector3d& axis : axes)
    shortest = std::min({shortest, way_along(a, b, axis), way_along(a, b, -axis)});
  return shortest;
}

TEST(LeastParting, OfBoxesIsThatOfTheirAxes) {
  RandomSource random(3);
  for (int i = 0; i < 50; ++i) {
    const Shape box_a = Box{{random.uniform(0.2, 1), random.uniform(0.2, 1), 0.5}};
    const Shape box_b = Box{{random.uniform(0.2, 1), 0.25, random.uniform(0.2, 1)}};
    const Pose pose_a = turned(random, near_by(random)), pose_b = turned(random, near_by(random));
    const PlacedBody a{box_a, pose_a}, b{box_b, pose_b};
    const auto found = least_parting(a, b, Vector3d::UnitX(), kTolerance);
    ASSERT_TRUE(found);
    const double shortest = shortest_by_axes(a, b);
    EXPECT_LE(found->least, shortest + kRounding);
    EXPECT_GE(found->most, shortest - kRounding);
    EXPECT_LE(found->most - found->least, kTolerance);
    EXPECT_NEAR(way_along(a, b, found->direction), found->most, kRounding);
  }
}

/// The directions are dense enough for the tolerance.
void expect_none_shorter(const LeastParting& found, const PlacedBody& a, const PlacedBody& b,
                         const std::vector<Vector3d>& directions) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Vector3d& n : directions)
    shortest = std::min(shortest, way_along(a, b, n));
  SCOPED_TRACE(std::string(name_of(a.shape.kind())) + " and " + name_of(b.shape.kind()));
  EXPECT_LE(found.least, shortest + kRounding);
  EXPECT_LE(found.most, shortest + kTolerance);
  EXPECT_NEAR(way_along(a, b, found.direction), found.most, kRounding);
}

TEST(LeastParting, NoDirectionOfManyIsShorter) {
  RandomSource random(5);
  std::vector<Vector3d> corners;
  for (int i = 0; i < 20; ++i)
    corners.push_back(near_by(random));
  const std::vector<Shape> shapes = {
      Sphere{{0.1, 0, 0}, 0.5}, Box{{0.5, 0.25, 0.75}}, Capsule{0.25, 0.5},
      Cylinder{0.5, 0.25},      Cone{0.5, 0.5},         Ellipsoid{{0, 0.2, 0}, {0.5, 1, 0.25}},
      ConvexHull(corners)};
  const std::vector<Vector3d> directions = many_directions(5000);
  for (const Shape& shape_a : shapes) {
    for (const Shape& shape_b : shapes) {
      for (int i = 0; i < 4; ++i) {
        const Pose pose_a = turned(random, near_by(random)),
                   pose_b = turned(random, near_by(random));
        const PlacedBody a{shape_a, pose_a}, b{shape_b, pose_b};
        const auto found = least_parting(a, b, near_by(random), kTolerance);
        ASSERT_TRUE(found);
        expect_none_shorter(*found, a, b, directions);
        EXPECT_LE(found->most - found->least, kTolerance);
      }
    }
  }
}

TEST(LeastParting, OfBallsIsWhatTheirRadiiSay) {
  const Shape small = Sphere{{0, 0, 0}, 0.25}, large = Sphere{{0, 0, 0}, 1};
  const Pose here = Pose::Identity();
  for (const double away : {0.0, 0.5, 2.0}) {
    Pose there = here;
    there.translation().y() = away;
    const auto found = least_parting({small, here}, {large, there}, {0, 0, 0}, kTolerance);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->most, 1.25 - away, kTolerance);
    EXPECT_NEAR(found->least, 1.25 - away, kTolerance);
  }
}

/// Whichever way one turns about a line it is as wide.
TEST(LeastParting, OfRoundShapesOnOneAxisIsNoDirectionOfManyShorterEither) {
  RandomSource random(13);
  const std::vector<Shape> shapes = {Sphere{{0, 0, 0.25}, 0.5},
                                     Capsule{0.25, 0.5},
                                     Cylinder{0.5, 0.25},
                                     Cone{0.5, 0.5},
                                     Ellipsoid{{0, 0, 0.25}, {0.5, 0.5, 1}},
                                     Ellipsoid{{0, 0, 0}, {0.5, 0.5, 0.5}}};
  const std::vector<Vector3d> directions = many_directions(20000);
  for (const Shape& shape_a : shapes) {
    for (const Shape& shape_b : shapes) {
      const Pose pose_a = turned(random, near_by(random));
      for (const double aside : {0.0, 1e-8, 1e-3}) {
        Pose pose_b = pose_a;
        pose_b.translation() += pose_a.linear() * Vector3d(aside, 0, random.uniform(-0.5, 0.5));
        const PlacedBody a{shape_a, pose_a}, b{shape_b, pose_b};
        const auto found = least_parting(a, b, near_by(random), kTolerance);
        ASSERT_TRUE(found);
        SCOPED_TRACE(aside);
        expect_none_shorter(*found, a, b, directions);
        if (aside < kTolerance) {
          EXPECT_LE(found->most - found->least, kTolerance);
        }
      }
    }
  }
}

/// As wide in all directions, and no line about which both may turn exactly: there is no end of it,
/// but the bounds are true and close.
TEST(LeastParting, OfWhatIsRoundAllAroundHasBoundsAllTheSame) {
  const Shape a = Ellipsoid{{0, 0, 0}, {1, 1, 1}}, b = Box{{0.5, 0.5, 0.5}};
  const Shape round = Ellipsoid{{0, 0, 0}, {0.5, 0.5, 0.5}};
  const Shape almost = Ellipsoid{{0, 0, 0}, {0.5, 0.5 + 1e-14, 0.5 - 1e-14}};
  const Pose here = Pose::Identity();
  const auto on_a_line = least_parting({a, here}, {round, here}, Vector3d::UnitX(), 1e-9);
  ASSERT_TRUE(on_a_line);
  EXPECT_NEAR(on_a_line->most, 1.5, kRounding);
  EXPECT_NEAR(on_a_line->least, 1.5, 1e-8);
  const auto found = least_parting({a, here}, {almost, here}, Vector3d::UnitX(), 1e-9);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->most, 1.5, kRounding);
  EXPECT_LE(found->least, 1.5);
  EXPECT_GE(found->least, 1.5 - 1e-3);
  EXPECT_NEAR(least_parting({a, here}, {b, here}, Vector3d(1, 2, 3), kTolerance)->most, 1.5,
              kTolerance);
}

TEST(LeastParting, OutOfAFlatOneGoesAlongItsNormal) {
  const Shape ground = HalfSpace{{0, 0, 1}, 0.5}, plane = Plane{{0, 0, 1}, 0.5};
  const Shape box = Box{{1, 1, 1}};
  const Pose here = Pose::Identity();
  Pose there = here;
  there.translation().z() = 0.25;
  const auto out = least_parting({ground, here}, {box, there}, {1, 0, 0}, kTolerance);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->most, 1.25);
  EXPECT_EQ(out->least, 1.25);
  EXPECT_EQ(out->direction, Vector3d(0, 0, 1));
  const auto swapped = least_parting({box, there}, {ground, here}, {1, 0, 0}, kTolerance);
  EXPECT_EQ(swapped->direction, Vector3d(0, 0, -1));
  EXPECT_EQ(least_parting({plane, here}, {box, there}, {1, 0, 0}, kTolerance)->most, 0.75);
  EXPECT_FALSE(least_parting({plane, here}, {ground, here}, {1, 0, 0}, kTolerance));
}

TEST(LeastParting, OfAMeshIsThatOfItsHull) {
  const Shape mesh = tests::make_box({1, 1, 1}), box = Box{{1, 0.5, 0.5}};
  const Pose here = Pose::Identity();
  Pose there = here;
  there.translation().x() = 1.75;
  EXPECT_NEAR(least_parting({mesh, here}, {box, there}, {0, 1, 0}, kTolerance)->most, 0.25,
              kRounding);
}

}  // namespace
}  // namespace graze::compare
