#pragma once

#include <graze/bvh/fit/methods/local_points.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace graze::bvh {

using Direction = std::array<double, 3>;

/// The first of the points that are lowest along a direction, and of those that are highest.
struct ExtremalPair {
  std::size_t low;
  std::size_t high;
};

/// Returns one pair for each direction.
std::vector<ExtremalPair> extremal_pairs(const LocalPoints& points,
                                         std::span<const Direction> directions);

}  // namespace graze::bvh
