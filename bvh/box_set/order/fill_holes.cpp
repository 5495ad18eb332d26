// New boxes among their neighbours, in the places of boxes that have gone.

#include <graze/bvh/box_set/order/box_order.h>
#include <graze/bvh/box_set/order/size_groups.h>

#include <algorithm>
#include <bit>
#include <new>

namespace graze::bvh {
namespace {

// Of more boxes between two refits each is not looked after: a sort costs less.
constexpr std::size_t kFewArrivals = 256;
constexpr std::size_t kArrivalShare = 6;

constexpr double kWidened = 2;  // how much wider a block may become than sorted ones are

/// Lane 0 of the result: what holds a lane and a box.
Block spanned(const Block& block, std::uint32_t lane, const OrderedBox& box) {
  Block both;
  for (std::size_t c = 0; c < 3; ++c) {
    both.row[c][0] = std::min(block.row[c][lane], high_half(box[c]));
    both.row[c + 3][0] = std::max(block.row[c + 3][lane], high_half(box[c + 3]));
  }
  return both;
}

/// The lanes of a block that hold a box already.
std::uint32_t holding_lanes(const Block& block, const OrderedBox& box) {
  std::int32_t holds[kLanes];
  std::fill_n(holds, kLanes, 1);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::int32_t low = high_half(box[c]), high = high_half(box[c + 3]);
    for (std::uint32_t lane = 0; lane < kLanes; ++lane)
      holds[lane] &= block.row[c][lane] <= low && high <= block.row[c + 3][lane];
  }
  std::uint32_t bits = 0;
  for (std::uint32_t lane = 0; lane < kLanes; ++lane)
    bits |= static_cast<std::uint32_t>(holds[lane]) << lane;
  return bits;
}

struct Choice {
  std::uint32_t lane = kNobody;
  double cost = 0;
  double extent = 0;  // with the box
};

/// Of some lanes of a block the one that the box widens least; of those that it does not widen the
/// narrowest.
Choice best_lane(const Block& block, const OrderedBox& box, std::uint32_t lanes) {
  Choice best;
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
    if (block.row[0][lane] > block.row[3][lane]) continue;
    const double with = extent(spanned(block, lane, box), 0);
    const double cost = with + (with - extent(block, lane));
    if (best.lane == kNobody || cost < best.cost) best = {lane, cost, with};
  }
  return best;
}

constexpr std::uint32_t kAllLanes = (1u << kLanes) - 1;

}  // namespace

/// False if none of the 256 places where the box belongs is empty and near.
bool BoxOrder::fill_hole(std::uint32_t proxy, const OrderedBox& box) {
  ++arrivals_;
  if (std::max(arrivals_, arrivals_before_) > kFewArrivals + store_.size / kArrivalShare)
    return false;
  if (store_.holes == 0 || store_.layers.size() < 2) return false;
  const std::uint8_t number = layer_of_class_[static_cast<std::size_t>(size_class(box))];
  if (number == kNoLayer) return false;
  Layer& layer = store_.layers[number];
  std::uint32_t block = 0;
  for (int level = layer.top; level > 1; --level) {
    const Block& here = layer.upper[level][block];
    const std::uint32_t holding = holding_lanes(here, box);
    const Choice choice = best_lane(here, box, holding != 0 ? holding : kAllLanes);
    if (choice.lane == kNobody) return false;
    block = block * kLanes + choice.lane;
  }
  const Choice choice = best_lane(layer.upper[1][block], box, layer.holed[block]);
  if (choice.lane == kNobody) return false;
  const std::uint32_t leaf = block * kLanes + choice.lane;
  const double usual = layer.sorted_extent[leaf] + extent(spanned(empty_block(), 0, box), 0);
  if (choice.extent > kWidened * usual) return false;
  if (!layer.is_filled[block]) {
    try {
      filled_.push_back({number, block});
    } catch (const std::bad_alloc&) {
      return false;
    }
  }
  layer.is_filled[block] = true;
  --store_.holes;
  store_.take(store_.empty_place(layer.first_block + leaf), proxy, box);
  if (store_.empty_place(layer.first_block + leaf) == kNobody) layer.note_filled(leaf);
  return true;
}

}  // namespace graze::bvh
