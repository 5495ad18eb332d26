#include <graze/bvh/box_set/store/box_store.h>

#include <algorithm>
#include <new>

namespace graze::bvh {
namespace {

// If one block in so many is dirty, refitting the paths of single blocks costs more than
// refitting all.
constexpr std::size_t kDirtyShare = 4;

constexpr std::size_t kGrowthShare = 32;  // one place in so many is reserved for boxes to come

constexpr std::size_t kBlocksPerTask = 512;
constexpr std::size_t kAhead = 32;  // boxes that are fetched before they are needed

/// Makes room for `count` more elements, and for one more in `share` of those that there are.
template <typename T>
void make_room_in(std::vector<T>& of, std::size_t count, std::size_t share) {
  if (of.size() + count > of.capacity()) of.reserve(of.size() + of.size() / share + count);
}

}  // namespace

std::size_t BoxStore::layer_of(std::uint32_t block) const {
  std::size_t layer = layers.size() - 1;
  while (layers[layer].first_block > block)
    --layer;
  return layer;
}

std::uint32_t BoxStore::empty_place(std::uint32_t block) const {
  for (std::uint32_t place = block * kLanes; place < (block + 1) * kLanes; ++place) {
    if (proxies[place] == kNullIndex) return place;
  }
  return kNullIndex;
}

void BoxStore::prefetch(std::uint32_t place) const {
  for (int c = 0; c < 6; ++c) {
    __builtin_prefetch(high[place >> kLaneBits].row[c]);
    __builtin_prefetch(low[place >> kLaneBits].row[c]);
  }
}

TreeView BoxStore::view(std::size_t layer) const {
  const Layer& of = layers[layer];
  return of.view(high.data() + of.first_block, low.data() + of.first_block,
                 proxies.data() + std::size_t{of.first_block} * kLanes);
}

/// Makes room. Before the first sort memory doubles, and the sort gives back what is too much.
void BoxStore::reserve(std::size_t boxes, std::uint32_t proxy_limit) {
  const std::size_t share = !was_sorted ? 1 : kGrowthShare;
  if (proxy_limit > places.size()) {
    make_room_in(places, proxy_limit - places.size(), share);
    places.resize(proxy_limit, kNullIndex);
  }
  if (layers.empty()) layers.emplace_back();
  Layer& last = layers.back();
  const std::size_t blocks = (newcomers + boxes + kLanes - 1) / kLanes;
  if (blocks <= last.block_count) return;
  const std::size_t more = blocks - last.block_count;
  make_room_in(high, more, share);
  make_room_in(low, more, share);
  make_room_in(proxies, more * kLanes, share);
  last.reserve(static_cast<std::uint32_t>(blocks));
}

bool BoxStore::has_room_for_one() {
  try {
    reserve(1, 0);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void BoxStore::mark_dirty(std::uint32_t block) {
  if (are_all_dirty) return;
  try {
    dirty.push_back(block);
    are_all_dirty = dirty.size() > high.size() / kDirtyShare + kLanes;
  } catch (const std::bad_alloc&) {
    are_all_dirty = true;
  }
}

void BoxStore::append(std::uint32_t proxy, const OrderedBox& box) {
  Layer& last = layers.back();
  if (newcomers % kLanes == 0) {
    high.push_back(empty_block());
    low.emplace_back();
    proxies.resize(proxies.size() + kLanes, kNullIndex);
    last.reshape(last.first_block, last.block_count + 1);
  }
  const std::uint32_t place = last.first_block * kLanes + static_cast<std::uint32_t>(newcomers++);
  take(place, proxy, box);
}

void BoxStore::take(std::uint32_t place, std::uint32_t proxy, const OrderedBox& box) {
  places[proxy] = place;
  proxies[place] = proxy;
  set_lane(high[place >> kLaneBits], low[place >> kLaneBits], place & (kLanes - 1), box);
  mark_dirty(place >> kLaneBits);
  ++size;
}

void BoxStore::erase(std::uint32_t proxy) {
  const std::uint32_t place = places[proxy];
  clear_lane(high[place >> kLaneBits], place & (kLanes - 1));
  proxies[place] = kNullIndex;
  places[proxy] = kNullIndex;
  mark_dirty(place >> kLaneBits);
  Layer& layer = layers[layer_of(place >> kLaneBits)];
  layer.note_hole((place >> kLaneBits) - layer.first_block);
  ++holes;
  --size;
}

void BoxStore::set(std::uint32_t place, const OrderedBox& box) {
  set_lane(high[place >> kLaneBits], low[place >> kLaneBits], place & (kLanes - 1), box);
  mark_dirty(place >> kLaneBits);
}

std::size_t BoxStore::bytes() const {
  std::size_t sum = high.capacity() * sizeof(Block) + low.capacity() * sizeof(LowBlock) +
                    (proxies.capacity() + places.capacity() + dirty.capacity()) * 4;
  for (const Layer& layer : layers) {
    for (const std::vector<Block>& level : layer.upper)
      sum += level.capacity() * sizeof(Block);
    sum += layer.sorted_perimeter.capacity() * sizeof(float) + layer.holed.capacity() * 2 +
           layer.is_filled.capacity() / 8;
  }
  return sum;
}

/// Writes blocks one after the other, each with the boxes that `input_of` its places names.
template <typename InputOf>
void ManyMoves::fill_blocks(std::span<const Aabb> boxes, const InputOf& input_of) {
  const std::size_t blocks = store_.high.size();
  workers_.for_each((blocks + kBlocksPerTask - 1) / kBlocksPerTask, [&](std::size_t chunk) {
    const std::size_t first = chunk * kBlocksPerTask * kLanes;
    const std::size_t last = std::min(first + kBlocksPerTask * kLanes, blocks * kLanes);
    for (std::size_t place = first; place < last; ++place) {
      // The boxes come in an order of their own: without this every one is waited for.
      const std::size_t later = input_of(std::min(place + kAhead, last - 1));
      if (later < boxes.size()) {
        __builtin_prefetch(boxes[later].min.data());
        __builtin_prefetch(boxes[later].max.data() + 2);
      }
      const std::size_t i = input_of(place);
      if (i >= boxes.size()) continue;
      const std::size_t block = place >> kLaneBits;
      set_lane(store_.high[block], store_.low[block], place & (kLanes - 1), ordered_box(boxes[i]));
    }
  });
  store_.are_all_dirty = true;
}

void ManyMoves::move_named(std::span<const Aabb> boxes) {
  fill_blocks(boxes, [&](std::size_t place) {
    if (!is_named_[place]) return boxes.size();
    return std::size_t{store_.low[place >> kLaneBits].row[0][place & (kLanes - 1)]};
  });
}

void ManyMoves::move_ranked(std::span<const Aabb> boxes) {
  fill_blocks(boxes, [&](std::size_t place) { return ranked_.rank(store_.proxies[place]); });
}

void ManyMoves::move_first(std::span<const Aabb> boxes) {
  fill_blocks(boxes, [&](std::size_t place) { return store_.proxies[place]; });
}

}  // namespace graze::bvh
