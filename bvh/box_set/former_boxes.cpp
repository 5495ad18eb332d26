#include <graze/bvh/box_set/former_boxes.h>
#include <graze/bvh/box_set/search/pair_kernels.h>

namespace graze::bvh {

void FormerBoxes::clear() {
  high_.clear();
  low_.clear();
  number_.clear();
  size_ = 0;
}

void FormerBoxes::add(std::uint32_t number, const OrderedBox& box) {
  const std::size_t lane = size_++ % kLanes;
  if (lane == 0) {
    high_.push_back(empty_block());
    low_.emplace_back();
    number_.resize(number_.size() + kLanes, kNullIndex);
  }
  set_lane(high_.back(), low_.back(), lane, box);
  number_[size_ - 1] = number;
}

void FormerBoxes::list_overlaps(PairBuffer& out) {
  out.clear();
  if (size_ == 0) return;
  layer_.reshape(0, static_cast<std::uint32_t>(high_.size()));
  layer_.refit_all(high_.data());
  const TreeView tree = layer_.view(high_.data(), low_.data(), number_.data());
  const auto level = static_cast<std::uint8_t>(layer_.top - 1);
  const BlockPair all = {0, 0, level, level, 0};
  find_pairs(tree, tree, {&all, 1}, out);
}

std::size_t FormerBoxes::bytes() const {
  std::size_t sum = high_.capacity() * sizeof(Block) + low_.capacity() * sizeof(LowBlock) +
                    number_.capacity() * sizeof(std::uint32_t);
  for (const std::vector<Block>& level : layer_.upper)
    sum += level.capacity() * sizeof(Block);
  return sum;
}

}  // namespace graze::bvh
