#include <graze/bvh/box_set/order/box_order.h>
#include <graze/bvh/box_set/order/size_classes.h>

#include <algorithm>
#include <bit>
#include <new>

namespace graze::bvh {
namespace {

// A set without searches for all pairs puts up with so many newcomers and holes, and so much
// degradation of blocks (layer.h), before it sorts.
constexpr std::size_t kFewNewcomers = 256;
constexpr std::size_t kNewcomerShare = 8;
constexpr std::size_t kHoleShare = 8;
constexpr std::size_t kQueryNewcomerShare = 4;
constexpr double kMuchDegraded = 4;

// Sorting costs so many pairs of blocks, which a search could have met instead, for each block.
constexpr double kSortCost = 80;

// Sorting costs so much for each newcomer, in blocks that a lookup could have met instead.
constexpr std::size_t kNewcomerSortCost = 8;

constexpr std::uint32_t kRefitChunk = 512;  // blocks, whole blocks of the level above

// A mover that stretches its block so far has left its neighbours. Movers are asked while they are
// few, one in so many boxes, and beyond that while one in so many of them has left.
constexpr double kLeft = 1.5;
constexpr std::size_t kAskedShare = 64;
constexpr std::size_t kLeftShare = 4;

// A block is looked at for outliers when its perimeter has grown by this factor, unless more than a
// few blocks have, one in so many. A box is an outlier if the block without it has at most so large
// a share of its perimeter.
constexpr double kStretched = 2;
constexpr std::size_t kFewStretched = 4;
constexpr std::size_t kStretchedShare = 32;
constexpr double kWorthMoving = 0.75;

// If more boxes than this arrive between two refits, no places are looked for one by one: a sort
// costs less.
constexpr std::size_t kFewArrivals = 256;
constexpr std::size_t kArrivalShare = 6;

constexpr double kWidened = 2;  // how much wider a block may become than sorted ones are

/// Returns in lane 0 the bounds of a lane and a box.
Block spanned(const Block& block, std::uint32_t lane, const OrderedBox& box) {
  Block both;
  for (std::size_t c = 0; c < 3; ++c) {
    both.row[c][0] = std::min(block.row[c][lane], high_half(box[c]));
    both.row[c + 3][0] = std::max(block.row[c + 3][lane], high_half(box[c + 3]));
  }
  return both;
}

/// Returns the lanes of a block that hold a box already, as bits.
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
  std::uint32_t lane = kNullIndex;
  double cost = 0;
  double perimeter = 0;  ///< the perimeter of the lane with the box
};

/// Returns that of some lanes of a block which the box widens least; of those that it does not
/// widen, the narrowest.
Choice best_lane(const Block& block, const OrderedBox& box, std::uint32_t lanes) {
  Choice best;
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
    if (block.row[0][lane] > block.row[3][lane]) continue;
    const double with = perimeter(spanned(block, lane, box), 0);
    const double cost = with + (with - perimeter(block, lane));
    if (best.lane == kNullIndex || cost < best.cost) best = {lane, cost, with};
  }
  return best;
}

constexpr std::uint32_t kAllLanes = (1u << kLanes) - 1;

}  // namespace

void BoxOrder::insert(std::uint32_t proxy, const OrderedBox& box) {
  store_.reserve(1, proxy + 1);
  if (!fill_hole(proxy, box)) store_.append(proxy, box);
}

/// True if a box goes so far from its neighbours that their block would span the space between.
bool BoxOrder::leaves_neighbours(const Layer& layer, std::uint32_t block,
                                 const OrderedBox& box) const {
  const std::uint32_t block_in_layer = block - layer.first_block;
  const Block& parent = layer.upper[1][block_in_layer >> kLaneBits];
  const std::uint32_t lane = block_in_layer & (kLanes - 1);
  Block spanned = empty_block();
  for (std::size_t c = 0; c < 3; ++c) {
    spanned.row[c][0] = std::min(parent.row[c][lane], high_half(box[c]));
    spanned.row[c + 3][0] = std::max(parent.row[c + 3][lane], high_half(box[c + 3]));
    spanned.row[c][1] = high_half(box[c]);
    spanned.row[c + 3][1] = high_half(box[c + 3]);
  }
  // Newcomers have no block of their own yet: any that they leave is a reason to look for one.
  if (block_in_layer >= layer.sorted_perimeter.size())
    return perimeter(spanned, 0) > perimeter(parent, lane);
  return perimeter(spanned, 0) >
         kLeft * (layer.sorted_perimeter[block_in_layer] + perimeter(spanned, 1));
}

void BoxOrder::move(std::uint32_t proxy, const OrderedBox& box) {
  const std::uint32_t place = store_.places[proxy];
  const std::uint32_t block = place >> kLaneBits;
  // If there are many movers, only a sample is asked whether they left, unless much of the sample
  // did.
  const bool is_asked =
      moves_ < kLanes + store_.size / kAskedShare || arrivals_ > moves_ / kLeftShare;
  ++moves_;
  const std::size_t layer = is_asked ? store_.layer_of(block) : 0;
  if (is_asked && leaves_neighbours(store_.layers[layer], block, box)) {
    store_.erase(proxy);
    if (fill_hole(proxy, box)) return;
    if (layer + 1 != store_.layers.size() && store_.has_room_for_one()) {
      store_.append(proxy, box);
      return;
    }
    // Its own place takes it back, which may be the only one that was empty in its block. Blocks of
    // newcomers have no marks of holes.
    --store_.holes;
    store_.take(place, proxy, box);
    Layer& of_block = store_.layers[layer];
    const std::uint32_t block_in_layer = block - of_block.first_block;
    if (block_in_layer + 1 < of_block.sorted_perimeter.size() &&
        store_.empty_place(block) == kNullIndex)
      of_block.note_filled(block_in_layer);
    return;
  }
  store_.set(place, box);
}

/// Puts the box into an empty place. Returns false if none of the 256 places where it belongs is
/// empty and near.
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
    const Block& node = layer.upper[level][block];
    const std::uint32_t holding = holding_lanes(node, box);
    const Choice choice = best_lane(node, box, holding != 0 ? holding : kAllLanes);
    if (choice.lane == kNullIndex) return false;
    block = block * kLanes + choice.lane;
  }
  const Choice choice = best_lane(layer.upper[1][block], box, layer.holed[block]);
  if (choice.lane == kNullIndex) return false;
  const std::uint32_t leaf = block * kLanes + choice.lane;
  const double usual = layer.sorted_perimeter[leaf] + perimeter(spanned(empty_block(), 0, box), 0);
  if (choice.perimeter > kWidened * usual) return false;
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
  if (store_.empty_place(layer.first_block + leaf) == kNullIndex) layer.note_filled(leaf);
  return true;
}

void BoxOrder::refit_and_regroup() {
  if (store_.are_all_dirty) {
    refit_every_layer();
    store_.are_all_dirty = false;
    store_.dirty.clear();
    move_outliers();
  }
  refit_dirty();
  sort_groups();
  arrivals_before_ = arrivals_;
  arrivals_ = moves_ = 0;
}

void BoxOrder::refit_every_layer() {
  degradation_ = 0;
  for (Layer& layer : store_.layers) {
    if (layer.block_count == 0) continue;
    const std::size_t chunks = (layer.block_count + kRefitChunk - 1) / kRefitChunk;
    std::vector<double>& sums = sums_;
    sums.assign(chunks, 0);
    layer.clear_above_boxes();
    workers_.for_each(chunks, [&](std::size_t chunk) {
      const auto first = static_cast<std::uint32_t>(chunk * kRefitChunk);
      const std::uint32_t last = std::min(first + kRefitChunk, layer.block_count);
      refit_blocks(store_.high.data() + layer.first_block, first, last, layer.upper[1].data());
      for (std::uint32_t b = first; b < last && b < layer.sorted_perimeter.size(); ++b)
        sums[chunk] +=
            degradation(layer.perimeter_of(b), layer.sorted_perimeter[b], layer.block_count);
    });
    for (const double sum : sums)
      degradation_ += sum;
    layer.refit_above(1, store_.high.data());
  }
}

void BoxOrder::refit_dirty() {
  if (store_.dirty.empty()) return;
  std::sort(store_.dirty.begin(), store_.dirty.end());
  store_.dirty.erase(std::unique(store_.dirty.begin(), store_.dirty.end()), store_.dirty.end());
  std::size_t next = 0;
  for (Layer& layer : store_.layers) {
    const std::size_t first = next;
    while (next < store_.dirty.size() && store_.dirty[next] < layer.first_block + layer.block_count)
      ++next;
    dirty_of_layer_.clear();
    for (std::size_t i = first; i < next; ++i)
      dirty_of_layer_.push_back(store_.dirty[i] - layer.first_block);
    const auto count_degradation = [&](double sign) {
      for (std::size_t i = first; i < next; ++i) {
        const std::uint32_t b = store_.dirty[i] - layer.first_block;
        if (b < layer.sorted_perimeter.size())
          degradation_ += sign * degradation(layer.perimeter_of(b), layer.sorted_perimeter[b],
                                             layer.block_count);
      }
    };
    count_degradation(-1);
    layer.refit_paths(store_.high.data(), dirty_of_layer_);
    count_degradation(1);
  }
  store_.dirty.clear();
}

/// Finds blocks that single boxes have stretched by leaving their neighbours, and moves those boxes
/// to the last layer. It does nothing if there are many such blocks, which a sort will see to.
void BoxOrder::move_outliers() {
  stretched_.clear();
  for (std::size_t l = 0; l + 1 < store_.layers.size(); ++l) {
    const Layer& layer = store_.layers[l];
    for (std::uint32_t b = 0; b < layer.sorted_perimeter.size(); ++b) {
      if (layer.perimeter_of(b) > kStretched * layer.sorted_perimeter[b])
        stretched_.push_back({l, b});
    }
  }
  if (stretched_.size() > kFewStretched + store_.high.size() / kStretchedShare) return;
  for (const StretchedBlock& of : stretched_) {
    while (move_outlier(of.layer, of.block)) {
    }
  }
}

/// Moves the box without which the block shrinks most, if that is worth it.
bool BoxOrder::move_outlier(std::size_t l, std::uint32_t b) {
  const std::uint32_t block = store_.layers[l].first_block + b;
  Block around = empty_block();  // lane i: the bounds of all lanes but i
  Block all = empty_block();
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    for (int c = 0; c < 3; ++c) {
      const std::int32_t low = store_.high[block].row[c][lane],
                         high = store_.high[block].row[c + 3][lane];
      for (std::uint32_t i = 0; i < kLanes; ++i) {
        Block& to = i == lane ? all : around;
        to.row[c][i] = std::min(to.row[c][i], low);
        to.row[c + 3][i] = std::max(to.row[c + 3][i], high);
      }
    }
  }
  Block whole = empty_block();
  for (int c = 0; c < 3; ++c) {
    whole.row[c][0] = *std::min_element(all.row[c], all.row[c] + kLanes);
    whole.row[c + 3][0] = *std::max_element(all.row[c + 3], all.row[c + 3] + kLanes);
  }
  std::uint32_t best = 0;
  for (std::uint32_t lane = 1; lane < kLanes; ++lane) {
    if (perimeter(around, lane) < perimeter(around, best)) best = lane;
  }
  const double now = perimeter(whole, 0);
  if (now <= kStretched * store_.layers[l].sorted_perimeter[b] ||
      perimeter(around, best) > kWorthMoving * now)
    return false;
  const std::uint32_t proxy = store_.proxies[block * kLanes + best];
  const OrderedBox box = store_.box(proxy);
  store_.reserve(1, 0);
  store_.erase(proxy);
  store_.append(proxy, box);
  return true;
}

void BoxOrder::prepare_for_queries() {
  refit_and_regroup();
  if (store_.newcomers > kFewNewcomers + store_.size / kQueryNewcomerShare ||
      degradation_ > kMuchDegraded * static_cast<double>(store_.high.size())) {
    sort();
  } else if (store_.newcomers > 2 * sorted_newcomers_ + kLanes) {
    sort_newcomers();
  }
}

void BoxOrder::prepare_for_lookups(std::size_t lookups) {
  refit_and_regroup();
  const double blocks = static_cast<double>(store_.high.size());
  if (store_.newcomers > kFewNewcomers + store_.size / kNewcomerShare ||
      store_.holes > kFewNewcomers + store_.size / kHoleShare || degradation_ > blocks) {
    sort();
    return;
  }
  // A lookup meets every block of newcomers in the order in which they came.
  const std::size_t unsorted = store_.newcomers - std::min(store_.newcomers, sorted_newcomers_);
  if (unsorted / kLanes * lookups > kNewcomerSortCost * store_.newcomers) sort_newcomers();
}

double BoxOrder::predicted_order_cost() const {
  const double blocks = static_cast<double>(store_.high.size());
  if (sorts_ == 0) return 0.5 * blocks * blocks;
  return static_cast<double>(met_sorted_) * degradation_ / std::max(1.0, blocks);
}

void BoxOrder::prepare_for_search() {
  refit_and_regroup();
  const double cost = kSortCost * static_cast<double>(store_.high.size());
  if (order_cost_ + predicted_order_cost() > cost || store_.holes > kLanes + store_.size / 8) {
    sort();
  } else if (store_.newcomers > sorted_newcomers_) {
    sort_newcomers();
  }
}

void BoxOrder::note_search(std::uint64_t met) {
  if (met_sorted_ == 0 && sorts_ != 0) met_sorted_ = met;
  if (met > met_sorted_) order_cost_ += static_cast<double>(met - met_sorted_);
}

}  // namespace graze::bvh
