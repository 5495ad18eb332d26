#pragma once

#include <graze/bvh/aabb.h>

#include <cstdint>
#include <ostream>
#include <vector>

namespace graze::bvh {

/// Distributions that builders find hard.
enum class Distribution {
  Uniform,
  OnePoint,
  Collinear,
  GiantAmongDust,
  Exponential,
  Flat,
  Grid,
  Huge,
  Tiny
};

inline constexpr Distribution kDistributions[] = {
    Distribution::Uniform,        Distribution::OnePoint,    Distribution::Collinear,
    Distribution::GiantAmongDust, Distribution::Exponential, Distribution::Flat,
    Distribution::Grid,           Distribution::Huge,        Distribution::Tiny};

/// For the names of tests.
void PrintTo(Distribution distribution, std::ostream* out);

std::vector<Aabb> random_boxes(Distribution distribution, std::size_t count, std::uint64_t seed);

}  // namespace graze::bvh
