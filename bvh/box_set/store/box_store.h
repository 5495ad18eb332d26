#pragma once

#include <graze/bvh/box_set/store/layer.h>
#include <graze/bvh/box_set/store/ranked_proxies.h>
#include <graze/bvh/box_set/store/workers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Keeps the boxes: blocks of 16, the proxy in each place, the place of each proxy, and the layers
/// that runs of blocks form. A place is 16 times a block plus a lane.
///
/// It decides nothing: BoxOrder says which place a box takes, and makes the bounds above blocks fit
/// what was dirty.
struct BoxStore {
  std::vector<Block> high;
  std::vector<LowBlock> low;
  std::vector<std::uint32_t> proxies;  ///< the proxy in each place; kNullIndex where a lane is
                                       ///< empty
  std::vector<std::uint32_t> places;   ///< the place of each proxy; kNullIndex for one without a
                                       ///< box
  std::vector<Layer> layers;           ///< the layers by size; the last holds what came since the
                                       ///< sort
  std::size_t size = 0;                ///< the number of boxes
  std::size_t newcomers = 0;  ///< places of the last layer that newcomers took, some left since
  std::size_t holes = 0;      ///< places that boxes have left
  std::vector<std::uint32_t> dirty;  ///< blocks whose boxes have changed since the last refit
  bool are_all_dirty = false;
  bool was_sorted = false;  ///< whether the boxes were ever sorted

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
  /// Returns a number that all proxies so far are below.
  std::uint32_t proxy_limit() const { return static_cast<std::uint32_t>(places.size()); }
  void prefetch(std::uint32_t place) const;

  /// Returns the layer that a block belongs to.
  std::size_t layer_of(std::uint32_t block) const;
  /// Returns a place in a block that holds no box; kNullIndex if there is none.
  std::uint32_t empty_place(std::uint32_t block) const;
  TreeView view(std::size_t layer) const;

  /// Makes room for so many more boxes, of proxies below the limit: append() will then throw
  /// nothing.
  void reserve(std::size_t boxes, std::uint32_t proxy_limit);
  /// Reserves for one box of a known proxy. Returns false if there is no memory for it.
  bool has_room_for_one();

  /// Gives an empty place to the proxy.
  void take(std::uint32_t place, std::uint32_t proxy, const OrderedBox& box);
  /// Adds a box to the last layer, where there must be room.
  void append(std::uint32_t proxy, const OrderedBox& box);
  void erase(std::uint32_t proxy);
  /// Changes a box where it is.
  void set(std::uint32_t place, const OrderedBox& box);
  /// Notes that the bounds above a block no longer fit. Where there is no memory to note that, all
  /// are noted.
  void mark_dirty(std::uint32_t block);

  std::size_t bytes() const;
};

/// Moves many boxes of a store at once.
class ManyMoves {
 public:
  ManyMoves(BoxStore& store, const Workers& workers) : store_(store), workers_(workers) {}

  /// Moves boxes: boxes[i] belongs to proxy_of(i), of equal proxies the last counts. Checks
  /// nothing.
  template <typename ProxyOf>
  void move(std::span<const Aabb> boxes, const ProxyOf& proxy_of) {
    // The number of a box's new value is noted where the box was: that place is written next.
    is_named_.assign(store_.proxies.size(), false);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const std::uint32_t place = store_.places[proxy_of(i)];
      is_named_[place] = true;
      store_.low[place >> kLaneBits].row[0][place & (kLanes - 1)] = static_cast<std::uint32_t>(i);
    }
    move_named(boxes);
  }

  /// Moves boxes: boxes[i] belongs to proxy i. It needs no list of which box is where.
  void move_first(std::span<const Aabb> boxes);

  /// Moves boxes: boxes[i] belongs to proxy_of(i), which ascends.
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
  std::vector<bool> is_named_;  ///< for each place, whether the box that is there moves
  RankedProxies ranked_;
};

}  // namespace graze::bvh
