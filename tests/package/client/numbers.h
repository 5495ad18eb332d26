#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <graze/bvh/pose.h>
#include <Eigen/Core>

// The inputs must be the same whatever flags this is compiled with. So they are made of integers,
// scaling by powers of two and literals, and no sum or product ever needs rounding.

namespace client {

/// number * 2^exponent. Where denormal numbers may be flushed to zero, these are made bit by bit.
inline double scaled(int number, int exponent) {
  if (exponent > -1000) return std::ldexp(number, exponent);
  const bool is_negative = number < 0;
  const auto size = static_cast<std::uint64_t>(is_negative ? -number : number);
  return std::bit_cast<double>(std::uint64_t{is_negative} << 63 | size << (exponent + 1074));
}

/// SplitMix64: Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014.
class Random {
 public:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// An integer in [-range, range].
  int integer(int range) {
    return static_cast<int>(next() % static_cast<std::uint64_t>(2 * range + 1)) - range;
  }

  /// A point of the lattice [-range, range]^3 times 2^exponent.
  Eigen::Vector3d point(int range, int exponent) {
    const double x = scaled(integer(range), exponent);
    const double y = scaled(integer(range), exponent);
    const double z = scaled(integer(range), exponent);
    return {x, y, z};
  }

 private:
  std::uint64_t state_ = 1;
};

/// `number` moved by a few units in its last place, away from zero if positive; next to zero it
/// stays.
inline double moved_by_ulps(double number, int ulps) {
  if (std::bit_cast<std::uint64_t>(number) << 1 < 64) return number;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) +
                               static_cast<std::uint64_t>(ulps));
}

/// Rotations by 1 radian about (1, 2, 3), by sqrt(2) about (3, -1, 2), by the golden angle about z,
/// and by 1e-9 about (1, -1, 0); no entry but those of the axis is a short binary number.
inline graze::Pose rotation(std::uint64_t index) {
  static constexpr std::array<std::array<double, 9>, 4> kRows = {{
      {0x1.257253328185ep-1, -0x1.37cfb7f60dc33p-1, 0x1.18b9b43dde003p-1,  //
       0x1.7b0f00d2d2379p-1, 0x1.57e1c9d814dd2p-1, -0x1.c8c6301fd4bd8p-6,  //
       -0x1.67b58de56ea35p-2, 0x1.b008182e98060p-2, 0x1.abf0e4ec0a6e9p-1},
      {0x1.65a884c02aea3p-1, -0x1.6aeeb0ce8ff6bp-1, 0x1.905f03c3bd2bcp-4,  //
       0x1.6371d36a53b8ep-2, 0x1.bad897ce8b1cbp-3, -0x1.d33a4b95ed672p-1,  //
       0x1.405fadba548f0p-1, 0x1.57c11c2fa955ap-1, 0x1.96a21300aba8ap-2},
      {-0x1.798869e0de833p-1, -0x1.59d9dd253cc13p-1, 0,  //
       0x1.59d9dd253cc13p-1, -0x1.798869e0de833p-1, 0,   //
       0, 0, 1},
      {1, 0, -0x1.84bc6eb0aa98ap-31,  //
       0, 1, -0x1.84bc6eb0aa98ap-31,  //
       0x1.84bc6eb0aa98ap-31, 0x1.84bc6eb0aa98ap-31, 1},
  }};
  const std::array<double, 9>& rows = kRows[index % kRows.size()];
  graze::Pose pose = graze::Pose::Identity();
  for (int i = 0; i < 9; ++i)
    pose.matrix()(i / 3, i % 3) = rows[static_cast<std::size_t>(i)];
  return pose;
}

}  // namespace client
