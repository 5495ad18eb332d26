#pragma once

#include <graze/bvh/box_set/search/pair_buffer.h>

#include <cstdint>
#include <vector>

namespace graze::bvh {

/// Writes the pairs in ascending order to `sorted`, which must not be `pairs`. All indices are
/// below `index_count`; `starts` is working memory. O(pairs + index_count) but for the order in a
/// row.
void sort_pairs(std::span<const BoxPair> pairs, std::uint32_t index_count,
                std::vector<std::uint32_t>& starts, PairBuffer& sorted);

/// Appends what is in `left` and not in `right`, both sorted.
void append_difference(std::span<const BoxPair> left, std::span<const BoxPair> right,
                       PairBuffer& out);

}  // namespace graze::bvh
