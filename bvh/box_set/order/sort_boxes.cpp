// This puts the boxes of a set into a new order.

#include <graze/bvh/box_set/order/box_order.h>
#include <graze/bvh/box_set/order/size_classes.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

constexpr std::size_t kMostLayers = 24;
constexpr std::size_t kSample = 1024;  // boxes that tell how densely all lie

constexpr std::size_t kRoomShare = 64;  // one block in so many is kept for newcomers

}  // namespace

/// Returns the centres of some boxes, relative to the lowest corner of all, which keeps them small
/// enough for float.
std::vector<KdItem> BoxOrder::sample_centres(const double* origin) const {
  std::vector<KdItem> sample;
  const std::size_t count = std::min(kSample, store_.proxies.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = i * store_.proxies.size() / count;
    if (store_.proxies[place] == kNullIndex) continue;
    const OrderedBox of = store_.box(store_.proxies[place]);
    sample.push_back({{}, store_.proxies[place]});
    for (std::size_t c = 0; c < 3; ++c)
      sample.back().centre[c] = centre(of[c], of[c + 3], origin[c]);
  }
  return sample;
}

/// Returns for each class of sizes the layer to which it goes.
std::vector<std::uint8_t> BoxOrder::choose_layers(std::span<const std::uint32_t> count_of_class,
                                                  const double* origin) const {
  std::vector<SizeClass> classes;
  for (std::size_t k = 0; k < kClasses; ++k) {
    if (count_of_class[k] != 0)
      classes.push_back(
          {std::ldexp(1.0, 2 * (static_cast<int>(k) - kClassShift) + 2), count_of_class[k]});
  }
  std::vector<KdItem> sample;
  if (classes.size() > 1) sample = sample_centres(origin);
  const std::vector<std::size_t> group = share_layers(classes, sample);
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
void BoxOrder::collect_items(SortSpace& space) const {
  std::vector<std::int16_t> classes(store_.proxies.size());
  std::vector<std::uint32_t> count(kClasses);
  double origin[3] = {0, 0, 0};
  bool is_first = true;
  for (std::uint32_t place = 0; place < store_.proxies.size(); ++place) {
    if (store_.proxies[place] == kNullIndex) continue;
    const OrderedBox of = store_.box_at(place);
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
  space.items.resize(store_.size);
  std::vector<std::uint32_t> next(start.begin(), start.end());
  for (std::uint32_t place = 0; place < store_.proxies.size(); ++place) {
    if (store_.proxies[place] == kNullIndex) continue;
    const OrderedBox of = store_.box_at(place);
    const auto number = static_cast<std::size_t>(classes[place]);
    KdItem& item = space.items[next[space.layer_of_class[number]]++];
    for (std::size_t c = 0; c < 3; ++c)
      item.centre[c] = centre(of[c], of[c + 3], origin[c]);
    item.proxy = store_.proxies[place];
  }
}

/// Makes the layers, their blocks and all that belongs to them, empty. After this nothing throws.
void BoxOrder::make_room_for_items(SortSpace& space) const {
  const std::vector<std::uint32_t>& start = space.starts;
  space.layers.resize(start.size());
  std::uint32_t blocks = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const std::uint32_t count = i + 1 == start.size() ? 0 : start[i + 1] - start[i];
    Layer& layer = space.layers[i];
    layer.reshape(blocks, (count + kLanes - 1) / kLanes);
    layer.sorted_perimeter.resize(layer.block_count);
    if (layer.block_count != 0) {
      layer.holed.assign(layer.upper[1].size(), 0);
      layer.is_filled.assign(layer.upper[1].size(), false);
    }
    blocks += layer.block_count;
  }
  // There is room for newcomers, so that the first of them does not double the memory.
  const std::size_t room = blocks + blocks / kRoomShare + kLanes;
  space.high.reserve(room), space.low.reserve(room), space.proxies.reserve(room * kLanes);
  space.high.assign(blocks, empty_block());
  space.low.resize(blocks);
  space.proxies.assign(std::size_t{blocks} * kLanes, kNullIndex);
}

/// Writes the boxes in the order of the items.
void BoxOrder::place_items(SortSpace& space) {
  const std::vector<KdItem>& items = space.items;
  const std::vector<std::uint32_t>& start = space.starts;
  for (std::size_t l = 0; l + 1 < start.size(); ++l) {
    std::uint32_t place = space.layers[l].first_block * kLanes;
    for (std::uint32_t i = start[l]; i < start[l + 1]; ++i, ++place) {
      const std::uint32_t proxy = items[i].proxy;
      const std::uint32_t from = store_.places[proxy];
      Block& high = space.high[place >> kLaneBits];
      LowBlock& low = space.low[place >> kLaneBits];
      for (int c = 0; c < 6; ++c) {
        high.row[c][place & (kLanes - 1)] =
            store_.high[from >> kLaneBits].row[c][from & (kLanes - 1)];
        low.row[c][place & (kLanes - 1)] =
            store_.low[from >> kLaneBits].row[c][from & (kLanes - 1)];
      }
      space.proxies[place] = proxy;
      store_.places[proxy] = place;
    }
  }
  store_.high.swap(space.high);
  store_.low.swap(space.low);
  store_.proxies.swap(space.proxies);
  store_.layers.swap(space.layers);
  layer_of_class_.swap(space.layer_of_class);
}

void BoxOrder::measure_sorted() {
  for (Layer& layer : store_.layers) {
    if (layer.block_count == 0) continue;
    layer.refit_all(store_.high.data());
    for (std::uint32_t b = 0; b < layer.block_count; ++b)
      layer.sorted_perimeter[b] = static_cast<float>(layer.perimeter_of(b));
  }
}

/// Puts the boxes that came since the last sort in order among themselves. They take no more room
/// than before: once they are listed, nothing throws.
void BoxOrder::sort_newcomers() {
  Layer& last = store_.layers.back();
  std::vector<KdItem> items;
  std::vector<OrderedBox> boxes;
  items.reserve(store_.newcomers), boxes.reserve(store_.newcomers);
  const std::uint32_t first = last.first_block * kLanes;
  for (std::uint32_t place = first; place < first + store_.newcomers; ++place) {
    if (store_.proxies[place] == kNullIndex) continue;
    const OrderedBox of = store_.box(store_.proxies[place]);
    items.push_back({{}, store_.proxies[place]});
    for (std::size_t c = 0; c < 3; ++c)
      items.back().centre[c] = centre(of[c], of[c + 3], 0);
  }
  kd_order(items);
  for (const KdItem& item : items)
    boxes.push_back(store_.box(item.proxy));
  store_.holes -= store_.newcomers - items.size();
  store_.newcomers = sorted_newcomers_ = items.size();
  const auto blocks = static_cast<std::uint32_t>((store_.newcomers + kLanes - 1) / kLanes);
  store_.high.resize(last.first_block);
  store_.high.resize(last.first_block + blocks, empty_block());
  store_.low.resize(last.first_block + blocks);
  store_.proxies.resize(first);
  store_.proxies.resize(first + blocks * kLanes, kNullIndex);
  last.reshape(last.first_block, blocks);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const std::uint32_t place = first + i;
    set_lane(store_.high[place >> kLaneBits], store_.low[place >> kLaneBits], place & (kLanes - 1),
             boxes[i]);
    store_.proxies[place] = items[i].proxy;
    store_.places[items[i].proxy] = place;
  }
  if (blocks != 0) last.refit_all(store_.high.data());
}

void BoxOrder::sort() {
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
  store_.newcomers = sorted_newcomers_ = store_.holes = 0;
  store_.are_all_dirty = false;
  store_.dirty.clear();
  filled_.clear();
  met_sorted_ = 0;
  order_cost_ = degradation_ = 0;
  store_.places.shrink_to_fit();
  store_.was_sorted = true;
  ++sorts_;
}

}  // namespace graze::bvh
