#include <graze/bvh/tree/box_separation.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
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
  EXPECT_FALSE(are_apart_along_faces(frame(identity, {kNan, 5, 0}, kNan), cube(1), cube(1)));
  EXPECT_FALSE(are_apart_along_faces(frame(identity, {5, 5, 5}, kInfinity), cube(1), cube(1)));
  EXPECT_FALSE(
      are_apart_along_faces(frame(identity, {kInfinity, 0, 0}, kInfinity), cube(1), cube(1)));
  EXPECT_EQ(gap_along_faces(frame(identity, {kNan, 0, 0}, 0), cube(1), cube(1)), 0);
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
    ASSERT_FALSE(are_apart_along_faces(frame(rotation, translation, 1e-13), a, b));
    const Eigen::Vector3d away = translation + Eigen::Vector3d(uniform(-4, 4), uniform(-4, 4), 0);
    found_apart += BoxSeparation(frame(rotation, away, 1e-13)).are_apart(a, b);
  }
  EXPECT_GT(found_apart, 10000);
}

/// How far two boxes are apart along an axis, in units of its length, negative where they overlap.
/// The second one's axes are the columns of `rotation`.
double gap_along(const Eigen::Vector3d& axis, const Eigen::Matrix3d& rotation,
                 const Eigen::Vector3d& offset, const Eigen::Vector3d& half_a,
                 const Eigen::Vector3d& half_b) {
  const Eigen::Vector3d in_b = rotation.transpose() * axis;
  return std::abs(axis.dot(offset)) - half_a.dot(axis.cwiseAbs()) - half_b.dot(in_b.cwiseAbs());
}

// Sharp: each of the fifteen axes separates boxes that no other separates, by more than the slack
// or by less.
TEST(BoxSeparation, EachOfTheFifteenAxesCountsByTheSlack) {
  std::mt19937_64 random(6);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  constexpr double kSlack = 0.01;
  int times_alone[15] = {}, times_within[15] = {};
  for (int n = 0; n < 30000; ++n) {
    const double w = uniform(-1, 1), x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    const Eigen::Matrix3d rotation = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    Eigen::Vector3d half_a, half_b, offset;
    FloatBox a, b;
    for (int k = 0; k < 3; ++k) {
      a.max[k] = static_cast<float>(uniform(0.01, 1));
      b.max[k] = static_cast<float>(uniform(0.01, 1));
      half_a[k] = a.max[k];
      half_b[k] = b.max[k];
      a.min[k] = -a.max[k];
      b.min[k] = -b.max[k];
      offset[k] = uniform(-2, 2);
    }
    double gaps[15];
    for (int k = 0; k < 15; ++k) {
      const Eigen::Vector3d axis =
          k < 3   ? Eigen::Vector3d(Eigen::Vector3d::Unit(k))
          : k < 6 ? Eigen::Vector3d(rotation.col(k - 3))
                  : Eigen::Vector3d(Eigen::Vector3d::Unit(k / 3 - 2).cross(rotation.col(k % 3)));
      gaps[k] = gap_along(axis, rotation, offset, half_a, half_b);
    }
    const auto widest = std::max_element(gaps, gaps + 15);
    if (std::abs(*widest - kSlack) < 1e-9) continue;
    const bool is_apart = *widest > kSlack;
    ASSERT_EQ(BoxSeparation(frame(rotation, offset, kSlack)).are_apart(a, b), is_apart) << n;
    const double along_faces = *std::max_element(gaps, gaps + 6);
    if (std::abs(along_faces - kSlack) >= 1e-9) {
      ASSERT_EQ(are_apart_along_faces(frame(rotation, offset, kSlack), a, b), along_faces > kSlack)
          << n;
    }
    ASSERT_NEAR(gap_along_faces(frame(rotation, offset, kSlack), a, b), std::max(along_faces, 0.0),
                1e-14);
    const auto separating =
        std::count_if(gaps, gaps + 15, [&](double gap) { return gap > kSlack; });
    times_alone[widest - gaps] += is_apart && separating == 1;
    times_within[widest - gaps] += !is_apart && *widest > 0;
  }
  for (int k = 0; k < 15; ++k) {
    EXPECT_GT(times_alone[k], 5) << k;
    EXPECT_GT(times_within[k], 0) << k;
  }
}

TEST(BoxSeparation, UnitsScaleEachSide) {
  RelativeFrame scaled = frame(Eigen::Matrix3d::Identity(), {3, 0, 0}, 0);
  scaled.units_b = 4;
  EXPECT_FALSE(BoxSeparation(scaled).are_apart(cube(1), cube(0.5f)));
  EXPECT_TRUE(BoxSeparation(scaled).are_apart(cube(0.5f), cube(0.5f)));
  EXPECT_FALSE(are_apart_along_faces(scaled, cube(1), cube(0.5f)));
  EXPECT_TRUE(are_apart_along_faces(scaled, cube(0.5f), cube(0.5f)));
  EXPECT_FALSE(BoxSeparation(scaled).is_first_larger(cube(1), cube(0.5f)));
  EXPECT_TRUE(BoxSeparation(scaled).is_first_larger(cube(3), cube(0.5f)));
}

}  // namespace
}  // namespace graze::bvh
