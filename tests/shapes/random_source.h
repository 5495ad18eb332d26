#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>

namespace graze {

/// Random numbers that are the same everywhere: std distributions differ between libraries.
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : random_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }

  /// Between low and high, both included.
  double integer(int low, int high) {
    return low + static_cast<double>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }

  /// uniform(low, high) times two to the power of integer(least, greatest).
  double uniform_at_scale(double low, double high, int least, int greatest) {
    const double mantissa = uniform(low, high);
    return std::ldexp(mantissa, static_cast<int>(integer(least, greatest)));
  }

  Eigen::Vector3d vector(double low, double high) {
    const double x = uniform(low, high);
    const double y = uniform(low, high);
    return {x, y, uniform(low, high)};
  }

  Eigen::Vector3d lattice_point(int low, int high) {
    const double x = integer(low, high);
    const double y = integer(low, high);
    return {x, y, integer(low, high)};
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace graze
