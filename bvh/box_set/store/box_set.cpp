#include <graze/bvh/box_set/store/box_set.h>

#include <algorithm>
#include <new>

namespace graze::bvh {
namespace {

// From here on refitting the paths of single blocks costs more than refitting all.
constexpr std::size_t kTouchedShare = 4;

// Crowds that a set without searches for all pairs puts up with before it sorts.
constexpr std::size_t kFewNewcomers = 256;
constexpr std::size_t kNewcomerShare = 8;
constexpr std::size_t kHoleShare = 8;
constexpr std::size_t kQueryNewcomerShare = 4;
constexpr double kMuchInflated = 4;

// What sorting newcomers costs, each, in blocks that a lookup could have met instead.
constexpr std::size_t kNewcomerSortCost = 8;

// A block is looked at for outliers when its extent has grown by this factor, unless one block in
// so many has; a box is one if the block without it has at most this share of its extent.
constexpr double kStretched = 2;
constexpr std::uint32_t kRefitChunk = 512;  // blocks, whole blocks of the level above

constexpr double kLeft = 1.5;  // a mover that stretches its block so far has left
constexpr std::size_t kAskedShare = 64;
constexpr std::size_t kLeftShare = 4;

constexpr std::size_t kFewStretched = 4;
constexpr std::size_t kStretchedShare = 32;
constexpr double kWorthMoving = 0.75;

constexpr std::size_t kGrowthShare = 32;

/// One in `share` of what it holds is added to what it is asked to hold.
template <typename T>
void make_room_in(std::vector<T>& of, std::size_t count, std::size_t share) {
  if (of.size() + count > of.capacity()) of.reserve(of.size() + of.size() / share + count);
}

}  // namespace

std::size_t BoxSet::layer_of(std::uint32_t block) const {
  std::size_t layer = layers_.size() - 1;
  while (layers_[layer].first_block > block)
    --layer;
  return layer;
}

OrderedBox BoxSet::box(std::uint32_t proxy) const {
  return box_at(place_[proxy]);
}

/// kNobody if there is none.
std::uint32_t BoxSet::empty_place(std::uint32_t block) const {
  for (std::uint32_t place = block * kLanes; place < (block + 1) * kLanes; ++place) {
    if (proxy_[place] == kNobody) return place;
  }
  return kNobody;
}

void BoxSet::prefetch(std::uint32_t place) const {
  for (int c = 0; c < 6; ++c) {
    __builtin_prefetch(high_[place >> kLaneBits].row[c]);
    __builtin_prefetch(low_[place >> kLaneBits].row[c]);
  }
}

TreeView BoxSet::view(int layer) const {
  const Layer& of = layers_[static_cast<std::size_t>(layer)];
  return of.view(high_.data() + of.first_block, low_.data() + of.first_block,
                 proxy_.data() + std::size_t{of.first_block} * kLanes);
}

/// Before the first sort memory doubles, and the sort gives back what is too much.
void BoxSet::reserve(std::size_t boxes, std::uint32_t proxy_limit) {
  const std::size_t share = sorts_ == 0 ? 1 : kGrowthShare;
  if (proxy_limit > place_.size()) {
    make_room_in(place_, proxy_limit - place_.size(), share);
    place_.resize(proxy_limit, kNobody);
  }
  if (layers_.empty()) layers_.emplace_back();
  Layer& last = layers_.back();
  const std::size_t blocks = (newcomers_ + boxes + kLanes - 1) / kLanes;
  if (blocks <= last.block_count) return;
  const std::size_t more = blocks - last.block_count;
  make_room_in(high_, more, share);
  make_room_in(low_, more, share);
  make_room_in(proxy_, more * kLanes, share);
  last.reserve(static_cast<std::uint32_t>(blocks));
}

bool BoxSet::has_room_for_one() {
  try {
    reserve(1, 0);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

/// Where there is no memory to note one, all are.
void BoxSet::touch(std::uint32_t block) {
  if (all_touched_) return;
  try {
    touched_.push_back(block);
    all_touched_ = touched_.size() > high_.size() / kTouchedShare + kLanes;
  } catch (const std::bad_alloc&) {
    all_touched_ = true;
  }
}

void BoxSet::insert(std::uint32_t proxy, const OrderedBox& box) {
  reserve(1, proxy + 1);
  if (!fill_hole(proxy, box)) append(proxy, box);
}

/// To the last layer, where there is room.
void BoxSet::append(std::uint32_t proxy, const OrderedBox& box) {
  Layer& last = layers_.back();
  if (newcomers_ % kLanes == 0) {
    high_.push_back(empty_block());
    low_.emplace_back();
    proxy_.resize(proxy_.size() + kLanes, kNobody);
    last.reshape(last.first_block, last.block_count + 1);
  }
  const std::uint32_t place = last.first_block * kLanes + static_cast<std::uint32_t>(newcomers_++);
  take(place, proxy, box);
}

/// An empty lane becomes the proxy's.
void BoxSet::take(std::uint32_t place, std::uint32_t proxy, const OrderedBox& box) {
  place_[proxy] = place;
  proxy_[place] = proxy;
  set_lane(high_[place >> kLaneBits], low_[place >> kLaneBits], place & (kLanes - 1), box);
  touch(place >> kLaneBits);
  ++size_;
}

void BoxSet::erase(std::uint32_t proxy) {
  const std::uint32_t place = place_[proxy];
  clear_lane(high_[place >> kLaneBits], place & (kLanes - 1));
  proxy_[place] = kNobody;
  place_[proxy] = kNobody;
  touch(place >> kLaneBits);
  Layer& layer = layers_[layer_of(place >> kLaneBits)];
  layer.note_hole((place >> kLaneBits) - layer.first_block);
  ++holes_;
  --size_;
}

/// A box that leaves its neighbours for good would make their block span the way between.
bool BoxSet::leaves_neighbours(const Layer& layer, std::uint32_t block,
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

void BoxSet::move(std::uint32_t proxy, const OrderedBox& box) {
  const std::uint32_t place = place_[proxy];
  const std::uint32_t block = place >> kLaneBits;
  // Of many movers only a sample is asked whether they left, unless much of it did.
  const bool is_asked = moves_ < kLanes + size_ / kAskedShare || arrivals_ > moves_ / kLeftShare;
  ++moves_;
  const std::size_t layer = is_asked ? layer_of(block) : 0;
  if (is_asked && leaves_neighbours(layers_[layer], block, box)) {
    erase(proxy);
    if (fill_hole(proxy, box)) return;
    if (layer + 1 != layers_.size() && has_room_for_one()) {
      append(proxy, box);
      return;
    }
    --holes_;
    take(place, proxy, box);
    return;
  }
  set_lane(high_[block], low_[block], place & (kLanes - 1), box);
  touch(block);
}

void BoxSet::refit() {
  if (all_touched_) {
    refit_every_layer();
    all_touched_ = false;
    touched_.clear();
    move_outliers();
  }
  refit_touched();
  sort_groups();
  arrivals_before_ = arrivals_;
  arrivals_ = moves_ = 0;
}

void BoxSet::refit_every_layer() {
  inflation_ = 0;
  for (Layer& layer : layers_) {
    if (layer.block_count == 0) continue;
    const std::size_t chunks = (layer.block_count + kRefitChunk - 1) / kRefitChunk;
    std::vector<double>& sums = scratch_.sums;
    sums.assign(chunks, 0);
    layer.clear_above_boxes();
    workers_.for_each(chunks, [&](std::size_t chunk) {
      const auto first = static_cast<std::uint32_t>(chunk * kRefitChunk);
      const std::uint32_t last = std::min(first + kRefitChunk, layer.block_count);
      refit_blocks(high_.data() + layer.first_block, first, last, layer.upper[1].data());
      for (std::uint32_t b = first; b < last && b < layer.sorted_extent.size(); ++b)
        sums[chunk] += inflation(layer.extent_of(b), layer.sorted_extent[b], layer.block_count);
    });
    for (const double sum : sums)
      inflation_ += sum;
    layer.refit_above(1, high_.data());
  }
}

void BoxSet::refit_touched() {
  if (touched_.empty()) return;
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  std::size_t next = 0;
  for (Layer& layer : layers_) {
    const std::size_t first = next;
    while (next < touched_.size() && touched_[next] < layer.first_block + layer.block_count)
      ++next;
    touched_here_.clear();
    for (std::size_t i = first; i < next; ++i)
      touched_here_.push_back(touched_[i] - layer.first_block);
    const auto count_inflation = [&](double sign) {
      for (std::size_t i = first; i < next; ++i) {
        const std::uint32_t b = touched_[i] - layer.first_block;
        if (b < layer.sorted_extent.size())
          inflation_ +=
              sign * inflation(layer.extent_of(b), layer.sorted_extent[b], layer.block_count);
      }
    };
    count_inflation(-1);
    layer.refit_paths(high_.data(), touched_here_);
    count_inflation(1);
  }
  touched_.clear();
}

/// Finds blocks that single boxes have stretched by leaving their neighbours, and moves those boxes
/// to the last layer; not if there are many such blocks, which a sort will see to.
void BoxSet::move_outliers() {
  std::vector<BlockPair>& stretched = scratch_.tasks;  // a: the block, trees: its layer
  stretched.clear();
  for (std::size_t l = 0; l + 1 < layers_.size(); ++l) {
    const Layer& layer = layers_[l];
    for (std::uint32_t b = 0; b < layer.sorted_extent.size(); ++b) {
      if (layer.extent_of(b) > kStretched * layer.sorted_extent[b])
        stretched.push_back({b, 0, 0, 0, static_cast<std::uint16_t>(l)});
    }
  }
  if (stretched.size() > kFewStretched + high_.size() / kStretchedShare) return;
  for (const BlockPair& of : stretched) {
    while (move_outlier(of.trees, of.a)) {
    }
  }
}

/// Moves the box without which the block shrinks most, if that is worth it.
bool BoxSet::move_outlier(std::size_t l, std::uint32_t b) {
  const std::uint32_t block = layers_[l].first_block + b;
  Block around = empty_block();  // lane i: the bounds of all lanes but i
  Block all = empty_block();
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    for (int c = 0; c < 3; ++c) {
      const std::int32_t low = high_[block].row[c][lane], high = high_[block].row[c + 3][lane];
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
  if (now <= kStretched * layers_[l].sorted_extent[b] || extent(around, best) > kWorthMoving * now)
    return false;
  const std::uint32_t proxy = proxy_[block * kLanes + best];
  const OrderedBox box = this->box(proxy);
  reserve(1, 0);
  erase(proxy);
  append(proxy, box);
  return true;
}

void BoxSet::find_overlapping(const OrderedBox& box, std::vector<std::uint32_t>& out) const {
  for (int layer = 0; layer < layer_count(); ++layer) {
    if (layers_[static_cast<std::size_t>(layer)].block_count != 0)
      bvh::find_overlapping(view(layer), box, out);
  }
}

void BoxSet::find_overlapping_either(std::span<const OrderedBox> before,
                                     std::span<const OrderedBox> after, Lookup& lookup,
                                     std::vector<MoverHit>& out) const {
  for (int layer = 0; layer < layer_count(); ++layer) {
    if (layers_[static_cast<std::size_t>(layer)].block_count != 0)
      bvh::find_overlapping_either(view(layer), before, after, lookup, out);
  }
}

void BoxSet::walk_along(const RaySlabs& ray, double& limit, const RayVisitor& visit) const {
  for (int layer = 0; layer < layer_count(); ++layer) {
    if (layers_[static_cast<std::size_t>(layer)].block_count != 0)
      bvh::walk_along(view(layer), ray, limit, visit);
  }
}

void BoxSet::prepare_for_queries() {
  refit();
  if (newcomers_ > kFewNewcomers + size_ / kQueryNewcomerShare ||
      inflation_ > kMuchInflated * static_cast<double>(high_.size())) {
    sort();
  } else if (newcomers_ > 2 * sorted_newcomers_ + kLanes) {
    sort_newcomers();
  }
}

void BoxSet::sort_if_crowded(std::size_t lookups) {
  const double blocks = static_cast<double>(high_.size());
  if (newcomers_ > kFewNewcomers + size_ / kNewcomerShare ||
      holes_ > kFewNewcomers + size_ / kHoleShare || inflation_ > blocks) {
    sort();
    return;
  }
  // A lookup meets every block of newcomers in the order in which they came.
  const std::size_t unsorted = newcomers_ - std::min(newcomers_, sorted_newcomers_);
  if (unsorted / kLanes * lookups > kNewcomerSortCost * newcomers_) sort_newcomers();
}

std::size_t BoxSet::bytes() const {
  std::size_t sum = high_.capacity() * sizeof(Block) + low_.capacity() * sizeof(LowBlock) +
                    (proxy_.capacity() + place_.capacity() + touched_.capacity()) * 4 +
                    filled_.capacity() * sizeof(FilledGroup);
  for (const Layer& layer : layers_) {
    for (const std::vector<Block>& level : layer.upper)
      sum += level.capacity() * sizeof(Block);
    sum += layer.sorted_extent.capacity() * sizeof(float) + layer.holed.capacity() * 2 +
           layer.is_filled.capacity() / 8;
  }
  sum += scratch_.is_named.capacity() / 8 + scratch_.ranked.bytes();
  for (const PairBuffer& found : scratch_.found)
    sum += found.capacity() * sizeof(BoxPair);
  return sum;
}

}  // namespace graze::bvh
