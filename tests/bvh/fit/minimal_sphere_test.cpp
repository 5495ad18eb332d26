// The smallest sphere against all balls through at most four of the points, and known cases.

#include <graze/bvh/fit/sphere_fit.h>
#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "tests/bvh/fit/point_sets.h"
#include "tests/shapes/random_source.h"

namespace graze::tests {
namespace {

using LongVector = Eigen::Matrix<long double, 3, 1>;

/// The radius of the smallest ball, which is circumscribed to at most four points: of all these
/// balls, each blown up to cover all points, the smallest.
class BruteForce {
 public:
  explicit BruteForce(const Points& points) {
    for (const Eigen::Vector3d& point : points)
      points_.push_back(point.cast<long double>());
    extend(0);
  }

  double radius() const { return static_cast<double>(std::sqrt(least_square_)); }

 private:
  void extend(std::size_t first) {
    for (std::size_t i = first; i < points_.size(); ++i) {
      chosen_.push_back(points_[i]);
      cover();
      if (chosen_.size() < 4) extend(i + 1);
      chosen_.pop_back();
    }
  }

  /// The centre c = p0 + sum l_i e_i with 2 e_j.(c - p0) = |e_j|^2 for each edge e_j from p0.
  void cover() {
    const auto count = static_cast<Eigen::Index>(chosen_.size()) - 1;
    Eigen::Matrix<long double, 3, Eigen::Dynamic> edges(3, count);
    for (Eigen::Index i = 0; i < count; ++i)
      edges.col(i) = chosen_[static_cast<std::size_t>(i) + 1] - chosen_[0];
    LongVector centre = chosen_[0];
    if (count > 0) {
      const Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> gram =
          2 * edges.transpose() * edges;
      const Eigen::Matrix<long double, Eigen::Dynamic, 1> squares =
          edges.colwise().squaredNorm().transpose();
      centre += edges * gram.fullPivLu().solve(squares);
    }
    long double square = 0;
    for (const LongVector& point : points_)
      square = std::max(square, (point - centre).squaredNorm());
    if (square < least_square_) least_square_ = square;
  }

  std::vector<LongVector> points_;
  std::vector<LongVector> chosen_;
  long double least_square_ = HUGE_VALL;
};

Points random_set(int kind, std::size_t count, RandomSource& source) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d point = source.vector(-1, 1);
    if (kind == 1) point = source.lattice_point(-2, 2);
    if (kind == 2) point /= point.norm();
    if (kind == 3) point.z() = 0.5 * point.x();
    if (kind == 4) point.z() *= 1e-7;
    if (kind == 5 && i > 0) point = points[0] + 1e-6 * point;
    points.push_back(point);
  }
  return points;
}

TEST(FitMinimalSphere, IsTheSmallestOfAllThroughFourPoints) {
  RandomSource source(6);
  for (int i = 0; i < 600; ++i) {
    const auto count = static_cast<std::size_t>(source.integer(1, 11));
    const Points points = random_set(i % 6, count, source);
    const double expected = BruteForce(points).radius();
    const double radius = bounding_sphere(points).radius;
    EXPECT_LE(radius, expected * (1 + 1e-12) + 1e-15) << i;
    EXPECT_GE(radius, expected * (1 - 1e-12)) << i;
  }
}

TEST(FitMinimalSphere, KnownCases) {
  const auto expect = [](const Points& points, const Eigen::Vector3d& centre, double radius) {
    const Sphere sphere = bounding_sphere(points);
    EXPECT_LE((sphere.centre - centre).norm(), 1e-14) << sphere.centre.transpose();
    EXPECT_NEAR(sphere.radius, radius, 1e-14 * radius);
  };
  expect({{0, 0, 0}, {2, 0, 0}}, {1, 0, 0}, 1);
  expect({{0, 0, 0}, {1, 0, 0}, {0.5, 0.1, 0}}, {0.5, 0, 0}, 0.5);
  expect({{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}, {0.5, std::sqrt(0.75) / 3, 0},
         1 / std::sqrt(3.0));
  expect({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {0, 0, 0}, std::sqrt(3.0));
  expect({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {0.5, 0.5, 0.5}, std::sqrt(0.75));
}

TEST(FitMinimalSphere, NeverLargerThanRitters) {
  for (const PointSet& set : hard_sets()) {
    const double ritter = ritter_sphere(set.points).radius;
    EXPECT_LE(bounding_sphere(set.points).radius, ritter) << set.name;
    EXPECT_LE(ritter, 1.5 * bounding_sphere(set.points).radius) << set.name;
  }
}

TEST(FitMinimalSphere, ScalesByPowersOfTwo) {
  for (const PointSet& set : plain_sets()) {
    for (double factor : {0x1p-300, 0x1p-3, 0x1p7, 0x1p500}) {
      const Points points = scaled(set.points, factor);
      EXPECT_EQ(bounding_sphere(points).centre, bounding_sphere(set.points).centre * factor);
      EXPECT_EQ(bounding_sphere(points).radius, bounding_sphere(set.points).radius * factor);
      EXPECT_EQ(ritter_sphere(points).centre, ritter_sphere(set.points).centre * factor);
      EXPECT_EQ(ritter_sphere(points).radius, ritter_sphere(set.points).radius * factor);
    }
  }
}

TEST(FitMinimalSphere, ManyPointsOnASphereComeToAnEnd) {
  RandomSource source(7);
  const double noises[] = {0, 1e-16, 1e-15, 1e-13, 1e-9};
  for (double noise : noises) {
    Points points;
    for (int i = 0; i < 20000; ++i) {
      Eigen::Vector3d point = source.vector(-1, 1);
      point *= (1 + source.uniform(0, noise)) / point.norm();
      points.push_back(point);
    }
    const Sphere sphere = bounding_sphere(points);
    EXPECT_NEAR(sphere.radius, 1 + noise, 1e-14 + 2 * noise);
    EXPECT_LE(sphere.centre.norm(), 1e-12 + 2 * noise);
  }
}

}  // namespace
}  // namespace graze::tests
