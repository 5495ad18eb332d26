#include <graze/bvh/box_set/store/layer.h>

#include <algorithm>
#include <cstring>

namespace graze::bvh {
namespace {

const Block* blocks_below(const Layer& layer, const Block* boxes, int level) {
  return level == 0 ? boxes + layer.first_block : layer.upper[level].data();
}

std::uint32_t count_on(const Layer& layer, int level) {
  return level == 0 ? layer.block_count : static_cast<std::uint32_t>(layer.upper[level].size());
}

bool same_lane(const Block& a, const Block& b, std::uint32_t lane) {
  bool is_same = true;
  for (int c = 0; c < 6; ++c)
    is_same &= a.row[c][lane] == b.row[c][lane];
  return is_same;
}

}  // namespace

void Layer::reshape(std::uint32_t first, std::uint32_t count) {
  first_block = first;
  block_count = count;
  const int old_top = top;
  std::uint32_t below = count;
  int level = 0;
  for (bool is_root = count == 0; !is_root;) {
    is_root = below == 1;
    below = (below + kLanes - 1) >> kLaneBits;
    upper[++level].resize(below, empty_block());
  }
  top = level;
  for (int l = top + 1; l < kMaxLevels; ++l)
    upper[l].clear();
  needs_refit_of_all |= top != old_top;
}

void Layer::reserve(std::uint32_t count) {
  std::uint32_t below = count;
  int level = 0;
  for (bool is_root = count == 0; !is_root;) {
    is_root = below == 1;
    below = (below + kLanes - 1) >> kLaneBits;
    std::vector<Block>& blocks = upper[++level];
    if (below > blocks.capacity()) blocks.reserve(std::max<std::size_t>(below, 2 * blocks.size()));
  }
}

void Layer::refit_all(const Block* boxes) {
  clear_above_boxes();
  refit_above(0, boxes);
}

void Layer::clear_above_boxes() {
  needs_refit_of_all = false;
  for (int level = 1; level <= top; ++level)
    std::fill(upper[level].begin(), upper[level].end(), empty_block());
}

void Layer::refit_above(int level, const Block* boxes) {
  for (; level < top; ++level)
    refit_blocks(blocks_below(*this, boxes, level), 0, count_on(*this, level),
                 upper[level + 1].data());
}

void Layer::refit_paths(const Block* boxes, std::vector<std::uint32_t>& dirty) {
  if (needs_refit_of_all) {
    refit_all(boxes);
    dirty.clear();
  }
  for (int level = 0; level < top && !dirty.empty(); ++level) {
    const Block* below = blocks_below(*this, boxes, level);
    std::size_t kept = 0;
    for (const std::uint32_t block : dirty) {
      Block& parent = upper[level + 1][block >> kLaneBits];
      const Block before = parent;
      refit_blocks(below, block, block + 1, upper[level + 1].data());
      const std::uint32_t above = block >> kLaneBits;
      const bool is_new = kept == 0 || dirty[kept - 1] != above;
      if (is_new && !same_lane(before, parent, block & (kLanes - 1))) dirty[kept++] = above;
    }
    dirty.resize(kept);
  }
  dirty.clear();
}

TreeView Layer::view(const Block* boxes, const LowBlock* low, const std::uint32_t* proxy) const {
  TreeView tree;
  tree.level[0] = boxes;
  for (int level = 1; level <= top; ++level)
    tree.level[level] = upper[level].data();
  tree.low = low;
  tree.proxy = proxy;
  tree.top = top;
  return tree;
}

void Layer::note_hole(std::uint32_t block) {
  if (block + 1 < sorted_perimeter.size())
    holed[block >> kLaneBits] |= static_cast<std::uint16_t>(1u << (block & (kLanes - 1)));
}

double Layer::perimeter_of(std::uint32_t block) const {
  return perimeter(upper[1][block >> kLaneBits], block & (kLanes - 1));
}

// The middle of the numbers with one high half; the first of some would be infinite.
constexpr std::uint32_t kMiddle = 0x80000000u;

double perimeter(const Block& block, std::uint32_t lane) {
  if (block.row[0][lane] > block.row[3][lane]) return 0;
  double sum = 0;
  for (int c = 0; c < 3; ++c)
    sum += 0.125 * value_of_key(joined(block.row[c + 3][lane], kMiddle)) -
           0.125 * value_of_key(joined(block.row[c][lane], kMiddle));
  return sum;
}

double degradation(double now, double sorted, double limit) {
  if (now <= sorted) return 0;
  const double ratio = now / sorted;  // infinite for what was a point
  return std::min(ratio * ratio * ratio - 1, limit);
}

}  // namespace graze::bvh
