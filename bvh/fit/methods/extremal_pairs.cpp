#include <graze/bvh/fit/methods/extremal_pairs.h>

#include <algorithm>
#include <limits>

namespace graze::bvh {
namespace {

constexpr std::size_t kLanes = LocalPoints::kLanes;
constexpr std::size_t kBlock = 32 * kLanes;

double height(const LocalPoints& points, std::size_t i, const Direction& d) {
  return (points.axis(0)[i] * d[0] + points.axis(1)[i] * d[1]) + points.axis(2)[i] * d[2];
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  std::size_t low_block = 0;
  std::size_t high_block = 0;
};

void widen(Range& range, const LocalPoints& points, const Direction& d, std::size_t begin) {
  const std::size_t end = std::min(begin + kBlock, points.padded_size());
  double low[kLanes];
  double high[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k)
    low[k] = high[k] = height(points, begin + k, d);
  for (std::size_t i = begin + kLanes; i < end; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double h = height(points, i + k, d);
      low[k] = h < low[k] ? h : low[k];
      high[k] = h > high[k] ? h : high[k];
    }
  }
  const double lowest = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
  const double highest = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
  if (lowest < range.low) {
    range.low = lowest;
    range.low_block = begin;
  }
  if (highest > range.high) {
    range.high = highest;
    range.high_block = begin;
  }
}

/// Returns the first point from `begin` on at a height that is known to be there: computed by the
/// same operations, it compares equal.
std::size_t first_at(const LocalPoints& points, const Direction& d, double wanted,
                     std::size_t begin) {
  while (height(points, begin, d) != wanted)
    ++begin;
  return begin;
}

}  // namespace

std::vector<ExtremalPair> extremal_pairs(const LocalPoints& points,
                                         std::span<const Direction> directions) {
  std::vector<Range> ranges(directions.size());
  for (std::size_t begin = 0; begin < points.padded_size(); begin += kBlock) {
    for (std::size_t i = 0; i < directions.size(); ++i)
      widen(ranges[i], points, directions[i], begin);
  }
  std::vector<ExtremalPair> pairs;
  pairs.reserve(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    pairs.push_back({first_at(points, directions[i], ranges[i].low, ranges[i].low_block),
                     first_at(points, directions[i], ranges[i].high, ranges[i].high_block)});
  }
  return pairs;
}

}  // namespace graze::bvh
