#pragma once

// This is private to engine/mesh.

#include <graze/engine/mesh/pair.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// Sorts pairs in ascending order.
void sort_pairs(std::vector<TrianglePair>& pairs);

/// The most numbers that rank_sort() takes: more are sorted in less time by other means, as
/// measured.
inline constexpr std::size_t kMostToRank = 80;

/// Writes the numbers to `sorted`, ascending. The place of each is the number of those that are
/// less: what takes a square of comparisons, several at a time and none of which has to be
/// foretold, is over sooner than any sort where there are few. There may be kMostToRank numbers at
/// most. Returns false if two are equal: `sorted` means nothing then.
bool rank_sort(std::span<const std::uint64_t> numbers, std::uint64_t* sorted);

}  // namespace graze
