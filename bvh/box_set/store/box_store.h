#pragma once

#include <graze/bvh/box_set/store/layer.h>
#include <graze/bvh/box_set/store/ranked_proxies.h>
#include <graze/bvh/box_set/store/workers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Where boxes are kept: blocks of 16, the proxy in each place, the place of each proxy, and the
/// layers that runs of blocks form. A place is 16 times a block plus a lane.
///
/// It decides nothing: BoxOrder says which place a box takes, and makes the bounds above blocks fit
/// what was dirty.
struct BoxStore {
  std::vector<Block> high;
  std::vector<LowBlock> low;
  std::vector<std::uint32_t> proxies;  ///< by place; kNullIndex where a lane is empty
  std::vector<std::uint32_t> places;   ///< by proxy; kNullIndex for one without a box
  std::vector<Layer> layers;           ///< by size; the last holds what came since the sort
  std::size_t size = 0;                ///< of boxes
  std::size_t newcomers = 0;           ///< places of the last layer that are or were taken
  std::size_t holes = 0;               ///< places that boxes have left
  std::vector<std::uint32_t> dirty;    ///< blocks whose boxes have changed since the last refit
  bool are_all_dirty = false;
  bool was_sorted = false;  ///< whether it ever was

  bool contains(std::uint32_t proxy) const {
    return proxy < places.size() && places[proxy] != kNullIndex;
  }
  std::uint32_t place(std::uint32_t proxy) const {
    return proxy < places.size() ? places[proxy] : kNullIndex;
  }
  OrderedBox box(std::uint32_t proxy) const { return box_at(places[proxy]); }
  OrderedBox box_at(std::uint32_t place) const {
    return lane_box(high[place >> kLaneBits], low[place >> kLaneBits], place & (kLanes - 1));
  }
  /// All proxies so far are below this.
  std::uint32_t proxy_limit() const { return static_cast<std::uint32_t>(places.size()); }
  void prefetch(std::uint32_t place) const;

  /// The layer that a block belongs to.
  std::size_t layer_of(std::uint32_t block) const;
  /// A place in a block that holds no box; kNullIndex if there is none.
  std::uint32_t empty_place(std::uint32_t block) const;
  TreeView view(std::size_t layer) const;

  /// Memory for so many more boxes, of proxies below the limit: append() will throw nothing.
  void reserve(std::size_t boxes, std::uint32_t proxy_limit);
  /// reserve() for one box of a known proxy, unless there is no memory.
  bool has_room_for_one();

  /// An empty place becomes the proxy's.
  void take(std::uint32_t place, std::uint32_t proxy, const OrderedBox& box);
  /// A box comes to the last layer, where there is room.
  void append(std::uint32_t proxy, const OrderedBox& box);
  void erase(std::uint32_t proxy);
  /// A box changes where it is.
  void set(std::uint32_t place, const OrderedBox& box);
  /// The bounds above a block no longer fit. Where there is no memory to note that, all are noted.
  void mark_dirty(std::uint32_t block);

  std::size_t bytes() const;
};

/// Moves many boxes of a store at once.
class ManyMoves {
 public:
  ManyMoves(BoxStore& store, const Workers& workers) : store_(store), workers_(workers) {}

  /// boxes[i] belongs to proxy_of(i), of equal proxies the last counts. Checks nothing.
  template <typename ProxyOf>
  void move(std::span<const Aabb> boxes, const ProxyOf& proxy_of) {
    // What a box will be is noted where it was: that place is written next.
    is_named_.assign(store_.proxies.size(), false);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const std::uint32_t place = store_.places[proxy_of(i)];
      is_named_[place] = true;
      store_.low[place >> kLaneBits].row[0][place & (kLanes - 1)] = static_cast<std::uint32_t>(i);
    }
    move_named(boxes);
  }

  /// boxes[i] belongs to proxy i. Needs no list of who is where.
  void move_first(std::span<const Aabb> boxes);

  /// boxes[i] belongs to proxy_of(i), which ascends.
  template <typename ProxyOf>
  void move_ascending(std::span<const Aabb> boxes, const ProxyOf& proxy_of) {
    ranked_.assign(store_.proxy_limit(), boxes.size(), proxy_of);
    move_ranked(boxes);
  }

  std::size_t bytes() const { return is_named_.capacity() / 8 + ranked_.bytes(); }

 private:
  void move_ranked(std::span<const Aabb> boxes);
  void move_named(std::span<const Aabb> boxes);
  template <typename InputOf>
  void fill_blocks(std::span<const Aabb> boxes, const InputOf& input_of);

  BoxStore& store_;
  const Workers& workers_;
  std::vector<bool> is_named_;  ///< by place: whether a box moves there
  RankedProxies ranked_;
};

}  // namespace graze::bvh
