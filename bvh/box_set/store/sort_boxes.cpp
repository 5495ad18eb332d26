// Putting the boxes of a set into a new order.

#include <graze/bvh/box_set/order/size_class.h>
#include <graze/bvh/box_set/order/size_groups.h>
#include <graze/bvh/box_set/store/box_set.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

// What sorting costs, in pairs of blocks that a search could have met instead, per block.
constexpr double kSortCost = 80;

constexpr std::size_t kMostLayers = 24;
constexpr std::size_t kSample = 1024;  // boxes that tell how densely all lie

constexpr std::size_t kRoomShare = 64;  // one block in so many is kept for newcomers

}  // namespace

double BoxSet::predicted_excess() const {
  const double blocks = static_cast<double>(high_.size());
  if (sorts_ == 0) return 0.5 * blocks * blocks;
  return static_cast<double>(met_sorted_) * inflation_ / std::max(1.0, blocks);
}

void BoxSet::sort_if_worthwhile() {
  const double cost = kSortCost * static_cast<double>(high_.size());
  if (excess_ + predicted_excess() > cost || holes_ > kLanes + size_ / 8) {
    sort();
  } else if (newcomers_ > sorted_newcomers_) {
    sort_newcomers();
  }
}

/// Centres of some boxes, from an origin that precision does not ask much of.
std::vector<KdItem> BoxSet::sample_centres(const double* origin) const {
  std::vector<KdItem> sample;
  const std::size_t count = std::min(kSample, proxy_.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = i * proxy_.size() / count;
    if (proxy_[place] == kNobody) continue;
    const OrderedBox of = box(proxy_[place]);
    sample.push_back({{}, proxy_[place]});
    for (std::size_t c = 0; c < 3; ++c)
      sample.back().centre[c] = centre(of[c], of[c + 3], origin[c]);
  }
  return sample;
}

/// Which layer each class of sizes goes to, by the class.
std::vector<std::uint8_t> BoxSet::choose_layers(std::span<const std::uint32_t> count_of_class,
                                                const double* origin) const {
  std::vector<SizeClass> classes;
  for (std::size_t k = 0; k < kClasses; ++k) {
    if (count_of_class[k] != 0)
      classes.push_back(
          {std::ldexp(1.0, 2 * (static_cast<int>(k) - kClassShift) + 2), count_of_class[k]});
  }
  std::vector<KdItem> sample;
  if (classes.size() > 1) sample = sample_centres(origin);
  const std::vector<std::size_t> group = group_sizes(classes, sample);
  // Where there are more groups than layers, the lowest ones share one.
  const std::size_t groups = group.empty() ? 0 : group.back() + 1;
  const std::size_t lowest = groups > kMostLayers ? groups - kMostLayers : 0;
  std::vector<std::uint8_t> layer_of_class(kClasses, kNoLayer);
  for (std::size_t k = 0, i = 0; k < kClasses; ++k) {
    if (count_of_class[k] != 0)
      layer_of_class[k] = static_cast<std::uint8_t>(std::max(group[i++], lowest) - lowest);
  }
  return layer_of_class;
}

/// Lists the boxes layer by layer.
void BoxSet::collect_items(SortSpace& space) const {
  std::vector<std::int16_t> classes(proxy_.size());
  std::vector<std::uint32_t> count(kClasses);
  double origin[3] = {0, 0, 0};
  bool is_first = true;
  for (std::uint32_t place = 0; place < proxy_.size(); ++place) {
    if (proxy_[place] == kNobody) continue;
    const OrderedBox of = box_at(place);
    classes[place] = static_cast<std::int16_t>(size_class(of));
    ++count[static_cast<std::size_t>(classes[place])];
    for (std::size_t c = 0; c < 3; ++c)
      origin[c] = is_first ? value_of_key(of[c]) : std::min(origin[c], value_of_key(of[c]));
    is_first = false;
  }
  space.layer_of_class = choose_layers(count, origin);
  std::vector<std::uint32_t>& start = space.starts;
  start.assign(1, 0);
  for (std::size_t k = 0; k < kClasses; ++k) {
    if (count[k] == 0) continue;
    start.resize(space.layer_of_class[k] + std::size_t{2}, start.back());
    start.back() += count[k];
  }
  space.items.resize(size_);
  std::vector<std::uint32_t> next(start.begin(), start.end());
  for (std::uint32_t place = 0; place < proxy_.size(); ++place) {
    if (proxy_[place] == kNobody) continue;
    const OrderedBox of = box_at(place);
    const auto number = static_cast<std::size_t>(classes[place]);
    KdItem& item = space.items[next[space.layer_of_class[number]]++];
    for (std::size_t c = 0; c < 3; ++c)
      item.centre[c] = centre(of[c], of[c + 3], origin[c]);
    item.proxy = proxy_[place];
  }
}

/// The layers, their blocks and all that belongs to them, empty: from here on nothing throws.
void BoxSet::make_room_for_items(SortSpace& space) const {
  const std::vector<std::uint32_t>& start = space.starts;
  space.layers.resize(start.size());
  std::uint32_t blocks = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const std::uint32_t count = i + 1 == start.size() ? 0 : start[i + 1] - start[i];
    Layer& layer = space.layers[i];
    layer.reshape(blocks, (count + kLanes - 1) / kLanes);
    layer.sorted_extent.resize(layer.block_count);
    if (layer.block_count != 0) {
      layer.holed.assign(layer.upper[1].size(), 0);
      layer.is_filled.assign(layer.upper[1].size(), false);
    }
    blocks += layer.block_count;
  }
  // With room for newcomers, so that the first of them does not double the memory.
  const std::size_t room = blocks + blocks / kRoomShare + kLanes;
  space.high.reserve(room), space.low.reserve(room), space.proxy.reserve(room * kLanes);
  space.high.assign(blocks, empty_block());
  space.low.resize(blocks);
  space.proxy.assign(std::size_t{blocks} * kLanes, kNobody);
}

/// Writes the boxes in the order of the items.
void BoxSet::place_items(SortSpace& space) {
  const std::vector<KdItem>& items = space.items;
  const std::vector<std::uint32_t>& start = space.starts;
  for (std::size_t l = 0; l + 1 < start.size(); ++l) {
    std::uint32_t place = space.layers[l].first_block * kLanes;
    for (std::uint32_t i = start[l]; i < start[l + 1]; ++i, ++place) {
      const std::uint32_t proxy = items[i].proxy;
      const std::uint32_t from = place_[proxy];
      Block& high = space.high[place >> kLaneBits];
      LowBlock& low = space.low[place >> kLaneBits];
      for (int c = 0; c < 6; ++c) {
        high.row[c][place & (kLanes - 1)] = high_[from >> kLaneBits].row[c][from & (kLanes - 1)];
        low.row[c][place & (kLanes - 1)] = low_[from >> kLaneBits].row[c][from & (kLanes - 1)];
      }
      space.proxy[place] = proxy;
      place_[proxy] = place;
    }
  }
  high_.swap(space.high);
  low_.swap(space.low);
  proxy_.swap(space.proxy);
  layers_.swap(space.layers);
  layer_of_class_.swap(space.layer_of_class);
}

void BoxSet::measure_sorted() {
  for (Layer& layer : layers_) {
    if (layer.block_count == 0) continue;
    layer.refit_all(high_.data());
    for (std::uint32_t b = 0; b < layer.block_count; ++b)
      layer.sorted_extent[b] = static_cast<float>(layer.extent_of(b));
  }
}

/// Puts the boxes that came since the last sort in order among themselves. They take no more room
/// than before: once they are listed, nothing throws.
void BoxSet::sort_newcomers() {
  Layer& last = layers_.back();
  std::vector<KdItem> items;
  std::vector<OrderedBox> boxes;
  items.reserve(newcomers_), boxes.reserve(newcomers_);
  const std::uint32_t first = last.first_block * kLanes;
  for (std::uint32_t place = first; place < first + newcomers_; ++place) {
    if (proxy_[place] == kNobody) continue;
    const OrderedBox of = box(proxy_[place]);
    items.push_back({{}, proxy_[place]});
    for (std::size_t c = 0; c < 3; ++c)
      items.back().centre[c] = centre(of[c], of[c + 3], 0);
  }
  kd_order(items);
  for (const KdItem& item : items)
    boxes.push_back(box(item.proxy));
  holes_ -= newcomers_ - items.size();
  newcomers_ = sorted_newcomers_ = items.size();
  const auto blocks = static_cast<std::uint32_t>((newcomers_ + kLanes - 1) / kLanes);
  high_.resize(last.first_block);
  high_.resize(last.first_block + blocks, empty_block());
  low_.resize(last.first_block + blocks);
  proxy_.resize(first);
  proxy_.resize(first + blocks * kLanes, kNobody);
  last.reshape(last.first_block, blocks);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const std::uint32_t place = first + i;
    set_lane(high_[place >> kLaneBits], low_[place >> kLaneBits], place & (kLanes - 1), boxes[i]);
    proxy_[place] = items[i].proxy;
    place_[items[i].proxy] = place;
  }
  if (blocks != 0) last.refit_all(high_.data());
}

void BoxSet::sort() {
  SortSpace space;
  collect_items(space);
  const std::vector<std::uint32_t>& start = space.starts;
  workers_.run([&] {
    for (std::size_t l = 0; l + 1 < start.size(); ++l)
      kd_order(std::span(space.items).subspan(start[l], start[l + 1] - start[l]));
  });
  make_room_for_items(space);
  place_items(space);
  measure_sorted();
  newcomers_ = sorted_newcomers_ = holes_ = 0;
  all_touched_ = false;
  touched_.clear();
  filled_.clear();
  met_sorted_ = 0;
  excess_ = inflation_ = 0;
  place_.shrink_to_fit();
  ++sorts_;
}

}  // namespace graze::bvh
