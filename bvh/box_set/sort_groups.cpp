// A new order for 16 neighbouring blocks among themselves, where boxes have come and gone.

#include <graze/bvh/box_set/box_set.h>
#include <graze/bvh/box_set/pair_kernels.h>

#include <algorithm>
#include <array>

namespace graze::bvh {
namespace {

// The blocks of a group may be so much inflated, summed, before it is sorted: as all blocks may.
constexpr double kMostInflated = kLanes;

struct GroupItem {
  std::array<double, 3> centre;
  std::uint32_t owner;
  std::uint32_t place;
};

std::size_t longest_axis(std::span<const GroupItem> items) {
  std::array<double, 3> low = items[0].centre, high = low;
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

/// Splits items evenly among blocks: which goes where follows from the items, not from their order.
void split(std::span<GroupItem> items, std::size_t blocks, std::size_t* counts) {
  if (blocks == 1) {
    *counts = items.size();
    std::sort(items.begin(), items.end(),
              [](const GroupItem& s, const GroupItem& t) { return s.owner < t.owner; });
    return;
  }
  const std::size_t left = items.size() / 2;
  if (!items.empty()) {
    const std::size_t axis = longest_axis(items);
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(left), items.end(),
                     [axis](const GroupItem& s, const GroupItem& t) {
                       return s.centre[axis] != t.centre[axis] ? s.centre[axis] < t.centre[axis]
                                                               : s.owner < t.owner;
                     });
  }
  split(items.first(left), blocks / 2, counts);
  split(items.subspan(left), blocks / 2, counts + blocks / 2);
}

}  // namespace

/// Of the groups to which boxes came since the last refit, those that this has stretched.
void BoxSet::sort_groups() {
  std::sort(filled_.begin(), filled_.end());
  filled_.erase(std::unique(filled_.begin(), filled_.end()), filled_.end());
  for (const FilledGroup& group : filled_)
    sort_group(layers_[group.layer], group.block);
  filled_.clear();
}

double BoxSet::inflation_of_group(const Layer& layer, std::uint32_t first) const {
  double sum = 0;
  for (std::uint32_t b = first; b < first + kLanes; ++b)
    sum += inflation(layer.girth_of(b), layer.sorted_girth[b], layer.block_count);
  return sum;
}

void BoxSet::sort_group(Layer& layer, std::uint32_t group) {
  const std::uint32_t first = group * kLanes;
  if (first + kLanes >= layer.block_count) return;  // the last one has lanes that are no holes
  const double before = inflation_of_group(layer, first);
  if (before <= kMostInflated) return;

  std::array<GroupItem, kLanes * kLanes> items;
  std::array<OrderedBox, kLanes * kLanes> boxes;
  std::uint32_t count = 0;
  const std::uint32_t base = (layer.first_block + first) * kLanes;
  for (std::uint32_t i = 0; i < kLanes * kLanes; ++i) {
    const std::uint32_t owner = owner_[base + i];
    if (owner == kNobody) continue;
    boxes[i] = box(owner);
    GroupItem& item = items[count++];
    for (std::size_t c = 0; c < 3; ++c)
      item.centre[c] = 0.5 * value_of_key(boxes[i][c]) + 0.5 * value_of_key(boxes[i][c + 3]);
    item.owner = owner;
    item.place = i;
  }
  std::size_t counts[kLanes];
  split(std::span(items).first(count), kLanes, counts);

  const GroupItem* next = items.data();
  for (std::uint32_t b = 0; b < kLanes; ++b) {
    Block& high = high_[layer.first_block + first + b];
    LowBlock& low = low_[layer.first_block + first + b];
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      const std::uint32_t place = base + b * kLanes + lane;
      owner_[place] = kNobody;
      if (lane >= counts[b]) {
        clear_lane(high, lane);
        continue;
      }
      set_lane(high, low, lane, boxes[next->place]);
      owner_[place] = next->owner;
      place_[next->owner] = place;
      ++next;
    }
  }
  refit_blocks(high_.data() + layer.first_block, first, first + kLanes, layer.upper[1].data());
  // No block may be held to a wider one than the widest: a bad order does not become the norm.
  const auto girths = layer.sorted_girth.begin() + first;
  const float widest = *std::max_element(girths, girths + kLanes);
  for (std::uint32_t b = first; b < first + kLanes; ++b)
    layer.sorted_girth[b] = std::min(static_cast<float>(layer.girth_of(b)), widest);
  inflation_ += inflation_of_group(layer, first) - before;
  ++groups_sorted_;
}

}  // namespace graze::bvh
