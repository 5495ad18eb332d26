#include <graze/bvh/box_set/block.h>
#include <graze/bvh/box_set/kd_order.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cstddef>

namespace graze::bvh {
namespace {

constexpr std::size_t kParallelItems = 16384;

/// The axis along which the centres reach furthest.
int longest_axis(std::span<const KdItem> items) {
  float low[3], high[3];
  for (int c = 0; c < 3; ++c)
    low[c] = high[c] = items[0].centre[c];
  for (const KdItem& item : items) {
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], item.centre[c]);
      high[c] = std::max(high[c], item.centre[c]);
    }
  }
  int axis = 0;
  for (int c = 1; c < 3; ++c) {
    if (high[c] - low[c] > high[axis] - low[axis]) axis = c;
  }
  return axis;
}

/// How many of `blocks` go to the left: about half of them, whole subtrees.
std::size_t left_blocks(std::size_t blocks) {
  std::size_t unit = 1;
  while (unit * kLanes < blocks)
    unit *= kLanes;
  const std::size_t units = (blocks + unit - 1) / unit;
  return units / 2 * unit;
}

void order(std::span<KdItem> items) {
  while (items.size() > kLanes) {
    const int axis = longest_axis(items);
    const std::size_t left = left_blocks((items.size() + kLanes - 1) / kLanes) * kLanes;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(left), items.end(),
                     [axis](const KdItem& s, const KdItem& t) {
                       if (s.centre[axis] != t.centre[axis]) return s.centre[axis] < t.centre[axis];
                       return s.owner < t.owner;
                     });
    if (items.size() >= kParallelItems) {
      tbb::parallel_invoke([=] { order(items.first(left)); }, [=] { order(items.subspan(left)); });
      return;
    }
    order(items.first(left));
    items = items.subspan(left);
  }
  // The cuts fix who shares a block, not the order in it, which is the library's affair.
  std::sort(items.begin(), items.end(), [](const KdItem& s, const KdItem& t) { return s.owner < t.owner; });
}

}  // namespace

void kd_order(std::span<KdItem> items) {
  if (!items.empty()) order(items);
}

}  // namespace graze::bvh
