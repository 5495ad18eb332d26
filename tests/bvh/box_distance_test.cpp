#include <graze/bvh/box_distance.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "tests/shapes/random_source.h"

namespace graze::bvh {
namespace {

FloatBox cube(float half) {
  return {{-half, -half, -half}, {half, half, half}};
}

RelativeFrame frame(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation,
                    double slack) {
  RelativeFrame result{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      result.rotation[i][j] = rotation(i, j);
    result.translation[i] = translation[i];
  }
  result.units_a = result.units_b = 1;
  result.slack = slack;
  return result;
}

double bound_of(const BoxDistance& distance, const FloatBox& a, const FloatBox& b) {
  return std::sqrt(distance.gap(a, b).squared_lower_bound);
}

TEST(BoxDistance, BetweenFacesAndBetweenCornersItIsTheDistance) {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  EXPECT_EQ(bound_of(BoxDistance(frame(identity, {5, 0, 0}, 0)), cube(1), cube(1)), 3);
  EXPECT_EQ(bound_of(BoxDistance(frame(identity, {5, 6, 0}, 0)), cube(1), cube(1)), 5);
  EXPECT_EQ(bound_of(BoxDistance(frame(identity, {5, 0, 0}, 0.5)), cube(1), cube(1)), 2.5);
  EXPECT_EQ(bound_of(BoxDistance(frame(identity, {1.5, 0, 0}, 0)), cube(1), cube(1)), 0);
}

TEST(BoxDistance, ADirectionHelpsWhereEdgesFaceEachOther) {
  const Eigen::Matrix3d turn_a =
      Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3d turn_b =
      Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const Eigen::Vector3d along = turn_a.transpose() * Eigen::Vector3d::UnitX();
  BoxDistance distance(frame(turn_a.transpose() * turn_b, 4 * along, 0));
  const double expected = 4 - 2 * std::sqrt(2.0);
  EXPECT_LT(bound_of(distance, cube(1), cube(1)), 0.9 * expected);
  distance.set_direction({along.x(), along.y(), along.z()});
  EXPECT_NEAR(bound_of(distance, cube(1), cube(1)), expected, 1e-12);
}

TEST(BoxDistance, NanAndInfinityGiveNoBound) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  EXPECT_EQ(bound_of(BoxDistance(frame(identity, {kNan, 5, 0}, kNan)), cube(1), cube(1)), 0);
  EXPECT_EQ(bound_of(BoxDistance(frame(identity, {kInfinity, 0, 0}, kInfinity)), cube(1), cube(1)),
            0);
}

TEST(Law5BoxDistance, NeverAboveTheDistanceOfTwoPoints) {
  RandomSource source(5);
  double tightest = 0;
  for (int n = 0; n < 20000; ++n) {
    const Eigen::Vector3d axis = source.vector(-1, 1);
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(source.uniform(-3, 3), axis.normalized()).toRotationMatrix();
    FloatBox a, b;
    Eigen::Vector3d in_a, in_b;
    for (int k = 0; k < 3; ++k) {
      a.min[k] = static_cast<float>(source.uniform(-1, 0));
      a.max[k] = a.min[k] + static_cast<float>(source.uniform(0, 1));
      b.min[k] = static_cast<float>(source.uniform(-1, 0));
      b.max[k] = b.min[k] + static_cast<float>(source.uniform(0, 1));
      in_a[k] = a.min[k] + (double{a.max[k]} - a.min[k]) * source.integer(0, 2) / 2;
      in_b[k] = b.min[k] + (double{b.max[k]} - b.min[k]) * source.integer(0, 2) / 2;
    }
    const Eigen::Vector3d translation = source.vector(-4, 4);
    BoxDistance distance(frame(rotation, translation, 1e-13));
    const Eigen::Vector3d way = rotation * in_b + translation - in_a;
    ASSERT_LE(bound_of(distance, a, b), way.norm());
    tightest = std::max(tightest, bound_of(distance, a, b) / way.norm());
    const Eigen::Vector3d direction = way.normalized();
    distance.set_direction({direction.x(), direction.y(), direction.z()});
    ASSERT_LE(bound_of(distance, a, b), way.norm());
    distance.set_limit(1);
    ASSERT_LE(bound_of(distance, a, b), way.norm());
  }
  EXPECT_GT(tightest, 0.99);
}

}  // namespace
}  // namespace graze::bvh
