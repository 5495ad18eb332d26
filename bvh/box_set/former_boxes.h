#pragma once

#include <graze/bvh/box_set/search/pair_lists.h>
#include <graze/bvh/box_set/store/block.h>
#include <graze/bvh/box_set/store/layer.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze::bvh {

/// Keeps where boxes were before they moved, and finds which of them overlapped there. Near ones
/// should be added one after the other: that order is the tree's.
class FormerBoxes {
 public:
  void clear();
  void add(std::uint32_t number, const OrderedBox& box);

  /// Finds all pairs of numbers whose boxes overlap, exactly, each once.
  void list_overlaps(PairBuffer& out);

  std::size_t bytes() const;

 private:
  std::vector<Block> high_;
  std::vector<LowBlock> low_;
  std::vector<std::uint32_t> number_;
  std::size_t size_ = 0;
  Layer layer_;
};

}  // namespace graze::bvh
