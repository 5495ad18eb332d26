#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace graze::bvh {

/// Returns 2^exponent. Queries of small meshes ask for it often enough to notice std::ldexp: where
/// it is a normal double its bits are known.
inline double power_of_two(int exponent) {
  constexpr int kBias = 1023;
  if (exponent <= -kBias || exponent > kBias) return std::ldexp(1.0, exponent);
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + kBias) << 52);
}

/// Returns std::ilogb() of what is positive and finite, which it reads from the bits of a normal
/// double.
inline int exponent_of(double positive) {
  constexpr int kBias = 1023;
  const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(positive) >> 52);
  return biased == 0 ? std::ilogb(positive) : biased - kBias;
}

}  // namespace graze::bvh
