#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace graze::generator {

/// Numbers that look random, but are a formula of the seed and of how many were drawn before. Made
/// of whole numbers, sums, products, quotients and square roots alone, in a fixed order: the same
/// on every machine.
class Dice {
 public:
  explicit Dice(std::int64_t seed) : seed_(seed) {}

  /// In [low, high).
  double uniform(double low, double high);

  /// Each coordinate in [-reach, reach).
  Eigen::Vector3d vector(const Eigen::Vector3d& reach);

  /// Of length 1, every direction as likely as any other.
  Eigen::Vector3d direction();

  /// Every rotation as likely as any other.
  Eigen::Matrix3d rotation();

 private:
  std::int64_t seed_;
  std::int64_t drawn_ = 0;
};

/// The rotation of the quaternion w + x i + y j + z k, which need not have length 1. Its columns
/// are orthonormal up to a few roundings.
Eigen::Matrix3d quaternion_rotation(double w, const Eigen::Vector3d& xyz);

/// x*x + y*y + z*z, summed in this order: Eigen's depends on how it vectorises.
double squared_length(const Eigen::Vector3d& v);

}  // namespace graze::generator
