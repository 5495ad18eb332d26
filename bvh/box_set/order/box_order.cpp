#include <graze/bvh/box_set/order/box_order.h>

#include <algorithm>

namespace graze::bvh {
namespace {

// How many newcomers and holes, and how much inflation of blocks (layer.h), a set without searches
// for all pairs puts up with before it sorts.
constexpr std::size_t kFewNewcomers = 256;
constexpr std::size_t kNewcomerShare = 8;
constexpr std::size_t kHoleShare = 8;
constexpr std::size_t kQueryNewcomerShare = 4;
constexpr double kMuchInflated = 4;

// What sorting newcomers costs, each, in blocks that a lookup could have met instead.
constexpr std::size_t kNewcomerSortCost = 8;

constexpr std::uint32_t kRefitChunk = 512;  // blocks, whole blocks of the level above

// A mover that stretches its block so far has left its neighbours. Movers are asked while they are
// few, one in so many boxes, and beyond that while one in so many of them has left.
constexpr double kLeft = 1.5;
constexpr std::size_t kAskedShare = 64;
constexpr std::size_t kLeftShare = 4;

// A block is looked at for outliers when its extent has grown by this factor, unless more than a
// few blocks have, one in so many. A box is an outlier if the block without it has at most so large
// a share of its extent.
constexpr double kStretched = 2;
constexpr std::size_t kFewStretched = 4;
constexpr std::size_t kStretchedShare = 32;
constexpr double kWorthMoving = 0.75;

}  // namespace

void BoxOrder::insert(std::uint32_t proxy, const OrderedBox& box) {
  store_.reserve(1, proxy + 1);
  if (!fill_hole(proxy, box)) store_.append(proxy, box);
}

/// A box that leaves its neighbours for good would make their block span the way between.
bool BoxOrder::leaves_neighbours(const Layer& layer, std::uint32_t block,
                                 const OrderedBox& box) const {
  const std::uint32_t here = block - layer.first_block;
  const Block& parent = layer.upper[1][here >> kLaneBits];
  const std::uint32_t lane = here & (kLanes - 1);
  Block spanned = empty_block();
  for (std::size_t c = 0; c < 3; ++c) {
    spanned.row[c][0] = std::min(parent.row[c][lane], high_half(box[c]));
    spanned.row[c + 3][0] = std::max(parent.row[c + 3][lane], high_half(box[c + 3]));
    spanned.row[c][1] = high_half(box[c]);
    spanned.row[c + 3][1] = high_half(box[c + 3]);
  }
  // Newcomers have no block of their own yet: any that they leave is a reason to look for one.
  if (here >= layer.sorted_extent.size()) return extent(spanned, 0) > extent(parent, lane);
  return extent(spanned, 0) > kLeft * (layer.sorted_extent[here] + extent(spanned, 1));
}

void BoxOrder::move(std::uint32_t proxy, const OrderedBox& box) {
  const std::uint32_t place = store_.places[proxy];
  const std::uint32_t block = place >> kLaneBits;
  // Of many movers only a sample is asked whether they left, unless much of it did.
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
    --store_.holes;
    store_.take(place, proxy, box);
    return;
  }
  store_.set(place, box);
}

void BoxOrder::refit() {
  if (store_.are_all_touched) {
    refit_every_layer();
    store_.are_all_touched = false;
    store_.touched.clear();
    move_outliers();
  }
  refit_touched();
  sort_groups();
  arrivals_before_ = arrivals_;
  arrivals_ = moves_ = 0;
}

void BoxOrder::refit_every_layer() {
  inflation_ = 0;
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
      for (std::uint32_t b = first; b < last && b < layer.sorted_extent.size(); ++b)
        sums[chunk] += inflation(layer.extent_of(b), layer.sorted_extent[b], layer.block_count);
    });
    for (const double sum : sums)
      inflation_ += sum;
    layer.refit_above(1, store_.high.data());
  }
}

void BoxOrder::refit_touched() {
  if (store_.touched.empty()) return;
  std::sort(store_.touched.begin(), store_.touched.end());
  store_.touched.erase(std::unique(store_.touched.begin(), store_.touched.end()),
                       store_.touched.end());
  std::size_t next = 0;
  for (Layer& layer : store_.layers) {
    const std::size_t first = next;
    while (next < store_.touched.size() &&
           store_.touched[next] < layer.first_block + layer.block_count)
      ++next;
    touched_here_.clear();
    for (std::size_t i = first; i < next; ++i)
      touched_here_.push_back(store_.touched[i] - layer.first_block);
    const auto count_inflation = [&](double sign) {
      for (std::size_t i = first; i < next; ++i) {
        const std::uint32_t b = store_.touched[i] - layer.first_block;
        if (b < layer.sorted_extent.size())
          inflation_ +=
              sign * inflation(layer.extent_of(b), layer.sorted_extent[b], layer.block_count);
      }
    };
    count_inflation(-1);
    layer.refit_paths(store_.high.data(), touched_here_);
    count_inflation(1);
  }
  store_.touched.clear();
}

/// Finds blocks that single boxes have stretched by leaving their neighbours, and moves those boxes
/// to the last layer; not if there are many such blocks, which a sort will see to.
void BoxOrder::move_outliers() {
  stretched_.clear();
  for (std::size_t l = 0; l + 1 < store_.layers.size(); ++l) {
    const Layer& layer = store_.layers[l];
    for (std::uint32_t b = 0; b < layer.sorted_extent.size(); ++b) {
      if (layer.extent_of(b) > kStretched * layer.sorted_extent[b]) stretched_.push_back({l, b});
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
    if (extent(around, lane) < extent(around, best)) best = lane;
  }
  const double now = extent(whole, 0);
  if (now <= kStretched * store_.layers[l].sorted_extent[b] ||
      extent(around, best) > kWorthMoving * now)
    return false;
  const std::uint32_t proxy = store_.proxies[block * kLanes + best];
  const OrderedBox box = store_.box(proxy);
  store_.reserve(1, 0);
  store_.erase(proxy);
  store_.append(proxy, box);
  return true;
}

void BoxOrder::prepare_for_queries() {
  refit();
  if (store_.newcomers > kFewNewcomers + store_.size / kQueryNewcomerShare ||
      inflation_ > kMuchInflated * static_cast<double>(store_.high.size())) {
    sort();
  } else if (store_.newcomers > 2 * sorted_newcomers_ + kLanes) {
    sort_newcomers();
  }
}

void BoxOrder::prepare_for_lookups(std::size_t lookups) {
  refit();
  const double blocks = static_cast<double>(store_.high.size());
  if (store_.newcomers > kFewNewcomers + store_.size / kNewcomerShare ||
      store_.holes > kFewNewcomers + store_.size / kHoleShare || inflation_ > blocks) {
    sort();
    return;
  }
  // A lookup meets every block of newcomers in the order in which they came.
  const std::size_t unsorted = store_.newcomers - std::min(store_.newcomers, sorted_newcomers_);
  if (unsorted / kLanes * lookups > kNewcomerSortCost * store_.newcomers) sort_newcomers();
}

void BoxOrder::note_search(std::uint64_t met) {
  if (met_sorted_ == 0 && sorts_ != 0) met_sorted_ = met;
  if (met > met_sorted_) excess_ += static_cast<double>(met - met_sorted_);
}

}  // namespace graze::bvh
