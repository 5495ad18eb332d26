#pragma once

// Private to engine/mesh.

#include <graze/engine/mesh/pair.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// Ascending.
void sort_pairs(std::vector<TrianglePair>& pairs);

/// Measured. More than these are sorted in less time by other means.
inline constexpr std::size_t kMostToRank = 80;

/// Writes so many numbers to `sorted`, ascending, each to the place that as many others are less
/// than it: what takes a square of comparisons, several at a time and none of which has to be
/// foretold, is over sooner than any sort where there are few. False if two are equal: `sorted`
/// means nothing then. kMostToRank numbers at most.
bool rank_sort(std::span<const std::uint64_t> numbers, std::uint64_t* sorted);

}  // namespace graze
