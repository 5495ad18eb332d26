#include <graze/bvh/box_set/order/kd_order.h>
#include <graze/bvh/box_set/store/block.h>
#include <graze/bvh/box_set/store/fork.h>

#include <algorithm>
#include <bit>
#include <cstddef>

namespace graze::bvh {
namespace {

constexpr std::size_t kParallelItems = 8192;  // fewer items are not shared among threads
constexpr std::size_t kSample = 64;           // items, among which a median is guessed

/// Returns the place of an item along an axis, which differs for different proxies.
std::uint64_t rank_key(const KdItem& item, int axis) {
  const auto bits = std::bit_cast<std::uint32_t>(item.centre[axis]);
  const std::uint32_t ordered =
      bits ^ (static_cast<std::uint32_t>(static_cast<std::int32_t>(bits) >> 31) | 0x80000000u);
  return static_cast<std::uint64_t>(ordered) << 32 | item.proxy;
}

/// Returns the axis along which the centres reach furthest, as far as some of them tell.
int longest_axis(std::span<const KdItem> items) {
  float low[3], high[3];
  for (int c = 0; c < 3; ++c)
    low[c] = high[c] = items[0].centre[c];
  const std::size_t step = std::max<std::size_t>(1, items.size() / (4 * kSample));
  for (std::size_t i = 0; i < items.size(); i += step) {
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], items[i].centre[c]);
      high[c] = std::max(high[c], items[i].centre[c]);
    }
  }
  int axis = 0;
  for (int c = 1; c < 3; ++c) {
    if (high[c] - low[c] > high[axis] - low[axis]) axis = c;
  }
  return axis;
}

/// Moves the items below the pivot to the front and returns their number. Every item is written
/// whether it moves or not: which side it belongs to cannot be foreseen.
std::size_t partition_below(std::span<KdItem> items, int axis, std::uint64_t pivot) {
  std::size_t below = 0;
  for (KdItem& here : items) {
    const KdItem item = here;
    here = items[below];
    items[below] = item;
    below += rank_key(item, axis) < pivot;
  }
  return below;
}

/// Sorts at most kSample items: each goes where the number of smaller ones says. The time is
/// quadratic, without a branch.
void sort_few(std::span<KdItem> items, int axis) {
  float key[kSample];
  std::int32_t rank[kSample] = {};
  KdItem sorted[kSample];
  const std::size_t count = items.size();
  for (std::size_t i = 0; i < count; ++i)
    key[i] = items[i].centre[axis];
  for (std::size_t i = 0; i < count; ++i) {
    const float here = key[i];
    for (std::size_t j = 0; j < i; ++j)
      rank[j] += here < key[j];
    for (std::size_t j = i + 1; j < count; ++j)
      rank[j] += here <= key[j];
  }
  for (std::size_t i = 0; i < count; ++i)
    sorted[rank[i]] = items[i];
  std::copy_n(sorted, count, items.begin());
}

/// Brings the `count` lowest items to the front. A pivot comes from a sample, a little on the far
/// side of where it is wanted, so that two or three passes bracket it (Floyd and Rivest 1975).
void select(std::span<KdItem> items, int axis, std::size_t count) {
  while (items.size() > kSample && count != 0 && count != items.size()) {
    std::uint64_t sample[kSample];
    for (std::size_t i = 0; i < kSample; ++i)
      sample[i] = rank_key(items[i * items.size() / kSample], axis);
    std::sort(sample, sample + kSample);
    const std::size_t wanted = count * kSample / items.size();
    constexpr std::size_t kMargin = kSample / 16;
    const bool is_low = count < items.size() / 2;
    const std::size_t at =
        is_low ? std::min(wanted + kMargin, kSample - 1) : wanted - std::min(wanted, kMargin);
    const std::size_t below = partition_below(items, axis, sample[at]);
    if (below == 0 || below == items.size()) break;  // the sample has misled
    if (count < below) {
      items = items.first(below);
    } else {
      items = items.subspan(below);
      count -= below;
    }
  }
  if (count == 0 || count == items.size()) return;
  if (items.size() <= kSample) {
    sort_few(items, axis);
  } else {
    std::sort(items.begin(), items.end(), [axis](const KdItem& s, const KdItem& t) {
      return rank_key(s, axis) < rank_key(t, axis);
    });
  }
}

/// Returns how many of `blocks` go to the left: about half of them, in whole subtrees.
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
    select(items, axis, left);
    if (items.size() >= kParallelItems) {
      fork_both([=] { order(items.first(left)); }, [=] { order(items.subspan(left)); });
      return;
    }
    order(items.first(left));
    items = items.subspan(left);
  }
}

}  // namespace

void kd_order(std::span<KdItem> items) {
  if (!items.empty()) order(items);
}

}  // namespace graze::bvh
