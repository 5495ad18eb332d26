#include <graze/bvh/box_separation.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

namespace graze::bvh {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

TEST(BoxSeparation, FacesApartByMoreThanTheSlack) {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  EXPECT_TRUE(BoxSeparation(frame(identity, {2.1, 0, 0}, 0.05)).are_apart(cube(1), cube(1)));
  EXPECT_FALSE(BoxSeparation(frame(identity, {2.1, 0, 0}, 0.15)).are_apart(cube(1), cube(1)));
  EXPECT_FALSE(BoxSeparation(frame(identity, {2, 0, 0}, 0)).are_apart(cube(1), cube(1)));
}

// Edge against edge: only a cross product of axes separates these.
TEST(BoxSeparation, CrossedEdgesNeedTheirCrossProduct) {
  const Eigen::Matrix3d turn_a =
      Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3d turn_b =
      Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const Eigen::Matrix3d relative = turn_a.transpose() * turn_b;
  const double touching = 2 * std::sqrt(2.0);
  const auto are_apart_at = [&](double distance) {
    const Eigen::Vector3d translation = turn_a.transpose() * Eigen::Vector3d(distance, 0, 0);
    return BoxSeparation(frame(relative, translation, 1e-12)).are_apart(cube(1), cube(1));
  };
  EXPECT_TRUE(are_apart_at(touching + 1e-6));
  EXPECT_FALSE(are_apart_at(touching - 1e-6));
}

TEST(BoxSeparation, NothingIsProvedByNanOrInfinity) {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  EXPECT_FALSE(BoxSeparation(frame(identity, {kNan, 5, 0}, kNan)).are_apart(cube(1), cube(1)));
  EXPECT_FALSE(BoxSeparation(frame(identity, {5, 5, 5}, kInfinity)).are_apart(cube(1), cube(1)));
  EXPECT_FALSE(
      BoxSeparation(frame(identity, {kInfinity, 0, 0}, kInfinity)).are_apart(cube(1), cube(1)));
}

// Conservative: a point of both boxes forbids "apart". And useful: boxes that a plane separates
// along one of the fifteen axes are found, which random directions here check against.
TEST(BoxSeparation, NeverApartWithACommonPoint) {
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  int found_apart = 0;
  for (int n = 0; n < 20000; ++n) {
    const Eigen::Matrix3d rotation =
        Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))
            .normalized()
            .toRotationMatrix();
    FloatBox a, b;
    for (int k = 0; k < 3; ++k) {
      a.min[k] = static_cast<float>(uniform(-1, 0));
      a.max[k] = a.min[k] + static_cast<float>(uniform(0, 1));
      b.min[k] = static_cast<float>(uniform(-1, 0));
      b.max[k] = b.min[k] + static_cast<float>(uniform(0, 1));
    }
    // A point of each, brought together.
    Eigen::Vector3d in_a, in_b;
    for (int k = 0; k < 3; ++k) {
      in_a[k] = a.min[k] + (double{a.max[k]} - a.min[k]) * static_cast<double>(random() % 3) / 2;
      in_b[k] = b.min[k] + (double{b.max[k]} - b.min[k]) * static_cast<double>(random() % 3) / 2;
    }
    const Eigen::Vector3d translation = in_a - rotation * in_b;
    ASSERT_FALSE(BoxSeparation(frame(rotation, translation, 1e-13)).are_apart(a, b));
    const Eigen::Vector3d away = translation + Eigen::Vector3d(uniform(-4, 4), uniform(-4, 4), 0);
    found_apart += BoxSeparation(frame(rotation, away, 1e-13)).are_apart(a, b);
  }
  EXPECT_GT(found_apart, 10000);
}

TEST(BoxSeparation, UnitsScaleEachSide) {
  RelativeFrame scaled = frame(Eigen::Matrix3d::Identity(), {3, 0, 0}, 0);
  scaled.units_b = 4;
  EXPECT_FALSE(BoxSeparation(scaled).are_apart(cube(1), cube(0.5f)));
  EXPECT_TRUE(BoxSeparation(scaled).are_apart(cube(0.5f), cube(0.5f)));
  EXPECT_FALSE(BoxSeparation(scaled).is_first_larger(cube(1), cube(0.5f)));
  EXPECT_TRUE(BoxSeparation(scaled).is_first_larger(cube(3), cube(0.5f)));
}

}  // namespace
}  // namespace graze::bvh
