#include <graze/bvh/tree/box_separation.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
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

/// gap_along_faces() written out: sums and products in the order in which they have always been.
double gap_written_out(const RelativeFrame& frame, const FloatBox& a, const FloatBox& b) {
  double half_a[3], half_b[3], centre_b[3], offset[3];
  for (int k = 0; k < 3; ++k) {
    half_a[k] = (double{a.max[k]} - a.min[k]) * (0.5 * frame.units_a);
    half_b[k] = (double{b.max[k]} - b.min[k]) * (0.5 * frame.units_b);
    centre_b[k] = (double{b.max[k]} + b.min[k]) * (0.5 * frame.units_b);
  }
  const auto& r = frame.rotation;
  double gap = 0;
  for (int i = 0; i < 3; ++i) {
    const double centre_a = (double{a.max[i]} + a.min[i]) * (0.5 * frame.units_a);
    offset[i] = frame.translation[i] - centre_a + r[i][0] * centre_b[0] + r[i][1] * centre_b[1] +
                r[i][2] * centre_b[2];
    const double radius = half_a[i] + std::abs(r[i][0]) * half_b[0] +
                          std::abs(r[i][1]) * half_b[1] + std::abs(r[i][2]) * half_b[2];
    gap = std::max(gap, std::abs(offset[i]) - radius);
  }
  for (int j = 0; j < 3; ++j) {
    const double distance = offset[0] * r[0][j] + offset[1] * r[1][j] + offset[2] * r[2][j];
    const double radius = half_b[j] + std::abs(r[0][j]) * half_a[0] +
                          std::abs(r[1][j]) * half_a[1] + std::abs(r[2][j]) * half_a[2];
    gap = std::max(gap, std::abs(distance) - radius);
  }
  return gap;
}

TEST(BoxSeparation, GapsAlongFacesAreTheSameBitForBit) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  const auto box = [&](int n) {
    FloatBox result;
    for (int k = 0; k < 3; ++k) {
      const auto from = static_cast<float>(uniform(-1, 1));
      const auto size = n % 5 == 0 ? 0.0f : static_cast<float>(std::ldexp(uniform(0, 1), -n % 40));
      result.min[k] = from, result.max[k] = from + size;
    }
    return result;
  };
  int apart = 0;
  for (int n = 0; n < 100000; ++n) {
    Eigen::Matrix3d rotation =
        Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))
            .normalized()
            .toRotationMatrix();
    if (n % 7 == 0) rotation.setIdentity();
    if (n % 11 == 0) rotation = -rotation.rowwise().reverse().eval();
    Eigen::Vector3d translation(uniform(-3, 3), uniform(-3, 3), uniform(-3, 3));
    if (n % 13 == 0) translation *= n % 2 == 0 ? 1e300 : 1e-300;
    if (n % 101 == 0) translation[n % 3] = n % 2 == 0 ? kNan : kInfinity;
    RelativeFrame between = frame(rotation, translation, uniform(0, 1));
    between.units_a = std::ldexp(1.0, n % 9 - 4);
    const FloatBox a = box(n), b = box(n / 3);
    const double expected = gap_written_out(between, a, b);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(gap_along_faces(between, a, b)),
              std::bit_cast<std::uint64_t>(expected))
        << n;
    apart += expected > 0;
  }
  EXPECT_GT(apart, 20000);
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
