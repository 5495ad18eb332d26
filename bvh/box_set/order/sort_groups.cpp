// This finds a new order for 16 neighbouring blocks among themselves, where boxes have come and
// gone.

#include <graze/bvh/box_set/order/box_order.h>
#include <graze/bvh/box_set/order/kd_order.h>

#include <algorithm>
#include <array>

namespace graze::bvh {
namespace {

// The degradation of a group's blocks, summed, may be so large before the group is sorted: that of
// all blocks may be as large.
constexpr double kMostDegraded = kLanes;

constexpr std::size_t kFewItems = 24;  // at most so many items are sorted in one go
constexpr int kMostCuts = 8;

using GroupBlocks = std::array<std::uint8_t, kLanes * kLanes>;

struct GroupItem {
  std::array<float, 3> centre;  ///< metres, from any box of the group
  std::uint32_t place;          ///< the place within the group
};

std::size_t longest_axis(std::span<const GroupItem> items) {
  std::array<float, 3> low = items[0].centre, high = low;
  for (const GroupItem& item : items) {
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], item.centre[c]);
      high[c] = std::max(high[c], item.centre[c]);
    }
  }
  std::size_t axis = 0;
  for (std::size_t c = 1; c < 3; ++c) {
    if (high[c] - low[c] > high[axis] - low[axis]) axis = c;
  }
  return axis;
}

float mean(std::span<const GroupItem> items, std::size_t axis) {
  double sum = 0;
  for (const GroupItem& item : items)
    sum += item.centre[axis];
  return static_cast<float>(sum / static_cast<double>(items.size()));
}

/// Moves the items below the pivot to the front and returns their number. Every item is written
/// whether it moves or not: which side it belongs to cannot be foreseen.
std::size_t partition_below(std::span<GroupItem> items, std::size_t axis, float pivot) {
  std::size_t below = 0;
  for (GroupItem& slot : items) {
    const GroupItem item = slot;
    slot = items[below];
    items[below] = item;
    below += item.centre[axis] < pivot;
  }
  return below;
}

/// Brings the `count` lowest items to the front: cuts at the mean leave few to choose among.
void select(std::span<GroupItem> items, std::size_t axis, std::size_t count) {
  for (int cut = 0; cut < kMostCuts && items.size() > kFewItems; ++cut) {
    const std::size_t below = partition_below(items, axis, mean(items, axis));
    if (count < below) {
      items = items.first(below);
    } else {
      items = items.subspan(below);
      count -= below;
    }
  }
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(count), items.end(),
                   [axis](const GroupItem& s, const GroupItem& t) {
                     return s.centre[axis] != t.centre[axis] ? s.centre[axis] < t.centre[axis]
                                                             : s.place < t.place;
                   });
}

/// Splits items evenly among blocks: which goes where follows from the items, not from their order.
void split(std::span<GroupItem> items, std::uint8_t first_block, std::uint8_t blocks,
           GroupBlocks& block_of) {
  if (blocks == 1) {
    for (const GroupItem& item : items)
      block_of[item.place] = first_block;
    return;
  }
  const std::size_t left = items.size() / 2;
  if (!items.empty()) select(items, longest_axis(items), left);
  const auto half = static_cast<std::uint8_t>(blocks / 2);
  split(items.first(left), first_block, half, block_of);
  split(items.subspan(left), static_cast<std::uint8_t>(first_block + half), half, block_of);
}

}  // namespace

/// Sorts those of the groups to which boxes came since the last refit that this has stretched.
void BoxOrder::sort_groups() {
  for (const FilledGroup& group : filled_) {
    store_.layers[group.layer].is_filled[group.block] = false;
    sort_group(store_.layers[group.layer], group.block);
  }
  filled_.clear();
}

double BoxOrder::degradation_of_group(const Layer& layer, std::uint32_t first) const {
  double sum = 0;
  for (std::uint32_t b = first; b < first + kLanes; ++b)
    sum += degradation(layer.perimeter_of(b), layer.sorted_perimeter[b], layer.block_count);
  return sum;
}

/// Moves the boxes to the blocks that they were given. Most boxes stay: only those move that change
/// their blocks.
void BoxOrder::regroup(std::uint32_t base, const GroupBlocks& block_of) {
  struct Mover {
    OrderedBox box;
    std::uint32_t proxy;
    std::uint32_t block;
  };
  std::array<Mover, kLanes * kLanes> movers;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < kLanes * kLanes; ++i) {
    const std::uint32_t place = base + i;
    if (store_.proxies[place] == kNullIndex || block_of[i] == i / kLanes) continue;
    movers[count++] = {store_.box_at(place), store_.proxies[place], block_of[i]};
    store_.proxies[place] = kNullIndex;
    clear_lane(store_.high[place >> kLaneBits], place & (kLanes - 1));
  }
  for (const Mover& mover : std::span(movers).first(count)) {
    const auto place = store_.empty_place(base / kLanes + mover.block);
    set_lane(store_.high[place >> kLaneBits], store_.low[place >> kLaneBits], place & (kLanes - 1),
             mover.box);
    store_.proxies[place] = mover.proxy;
    store_.places[mover.proxy] = place;
  }
}

void BoxOrder::sort_group(Layer& layer, std::uint32_t group) {
  const std::uint32_t first = group * kLanes;
  if (first + kLanes >= layer.block_count) return;  // the last one has lanes that are no holes
  const double before = degradation_of_group(layer, first);
  if (before <= kMostDegraded) return;

  std::array<GroupItem, kLanes * kLanes> items;
  std::uint32_t count = 0;
  double origin[3] = {0, 0, 0};
  const std::uint32_t base = (layer.first_block + first) * kLanes;
  for (std::uint32_t i = 0; i < kLanes * kLanes; ++i) {
    if (store_.proxies[base + i] == kNullIndex) continue;
    const OrderedBox box = store_.box_at(base + i);
    GroupItem& item = items[count++];
    for (std::size_t c = 0; c < 3; ++c) {
      if (count == 1) origin[c] = value_of_key(box[c]);
      item.centre[c] = centre(box[c], box[c + 3], origin[c]);
    }
    item.place = i;
  }
  GroupBlocks block_of;
  split(std::span(items).first(count), 0, kLanes, block_of);
  regroup(base, block_of);
  for (std::uint32_t b = first; b < first + kLanes; ++b) {
    layer.note_filled(b);
    if (store_.empty_place(layer.first_block + b) != kNullIndex) layer.note_hole(b);
  }
  refit_blocks(store_.high.data() + layer.first_block, first, first + kLanes,
               layer.upper[1].data());
  // No block may be held to a wider perimeter than the widest had: a bad order does not become the
  // norm.
  const auto perimeters = layer.sorted_perimeter.begin() + first;
  const float widest = *std::max_element(perimeters, perimeters + kLanes);
  for (std::uint32_t b = first; b < first + kLanes; ++b)
    layer.sorted_perimeter[b] = std::min(static_cast<float>(layer.perimeter_of(b)), widest);
  degradation_ += degradation_of_group(layer, first) - before;
  ++groups_sorted_;
}

}  // namespace graze::bvh
