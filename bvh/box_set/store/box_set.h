#pragma once

#include <graze/bvh/box_set/order/kd_order.h>
#include <graze/bvh/box_set/order/workers.h>
#include <graze/bvh/box_set/search/pair_kernels.h>
#include <graze/bvh/box_set/search/ray_walk.h>
#include <graze/bvh/box_set/store/layer.h>
#include <graze/bvh/box_set/store/ranked_proxies.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Many boxes that move, each known by its proxy, in blocks of 16 under implicit trees: one tree
/// for each group of sizes, by factors of 4 or more, and one for boxes that came since the last
/// sort. Finds what overlaps, exactly on the doubles given.
///
/// After insert(), move(), erase() or set_all() call refit() before finding anything.
///
/// What throws for want of memory has lost no box: insert() has not happened, and what puts boxes
/// in order can be asked for again. move() and erase() throw nothing: where there is no memory for
/// what saves time later, they do without.
class BoxSet {
 public:
  /// `threads` share the work; no result depends on their number.
  explicit BoxSet(int threads) : workers_(threads) {}

  const Workers& workers() const { return workers_; }

  std::size_t size() const { return size_; }
  bool contains(std::uint32_t proxy) const {
    return proxy < place_.size() && place_[proxy] != kNobody;
  }
  OrderedBox box(std::uint32_t proxy) const;
  /// Near boxes have near places. kNobody for a proxy without a box.
  std::uint32_t place(std::uint32_t proxy) const {
    return proxy < place_.size() ? place_[proxy] : kNobody;
  }
  void prefetch(std::uint32_t place) const;
  /// All proxies so far are below this.
  std::uint32_t proxy_limit() const { return static_cast<std::uint32_t>(place_.size()); }

  /// Memory for so many more boxes, of proxies below the limit: insert() will throw nothing.
  void reserve(std::size_t boxes, std::uint32_t proxy_limit);

  void insert(std::uint32_t proxy, const OrderedBox& box);
  void move(std::uint32_t proxy, const OrderedBox& box);
  void erase(std::uint32_t proxy);

  /// Moves many: boxes[i] belongs to proxy_of(i), of equal proxies the last counts. Checks nothing.
  template <typename ProxyOf>
  void move_many(std::span<const Aabb> boxes, const ProxyOf& proxy_of) {
    // What a box will be is noted where it was: that place is written next.
    scratch_.is_named.assign(proxy_.size(), false);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const std::uint32_t place = place_[proxy_of(i)];
      scratch_.is_named[place] = true;
      low_[place >> kLaneBits].row[0][place & (kLanes - 1)] = static_cast<std::uint32_t>(i);
    }
    move_named(boxes);
  }

  /// Moves the proxies 0, 1, 2 ...: boxes[i] belongs to proxy i. Needs no list of who is where.
  void move_first(std::span<const Aabb> boxes);

  /// Moves many, in ascending order: boxes[i] belongs to proxy_of(i).
  template <typename ProxyOf>
  void move_ascending(std::span<const Aabb> boxes, const ProxyOf& proxy_of) {
    scratch_.ranked.assign(proxy_limit(), boxes.size(), proxy_of);
    move_ranked(boxes);
  }

  /// Makes the bounds fit the boxes again. Costs what was touched.
  void refit();

  /// refit(), and an order for boxes if many came: what queries want.
  void prepare_for_queries();

  /// Puts all boxes into a new order, if the old one has cost more by now than that does.
  /// `is_about_to_find_all` pairs: then what the next search would cost counts as well.
  void sort_if_worthwhile();
  void sort();

  /// The same before so many lookups, for boxes that came in a crowd.
  void sort_if_crowded(std::size_t lookups);

  /// All pairs that overlap, each once, in an order that the history of the set decides.
  void find_all_pairs(PairBuffer& out);

  /// Appends the proxies of all boxes that overlap `box`.
  void find_overlapping(const OrderedBox& box, std::vector<std::uint32_t>& out) const;

  /// Appends what overlaps movers where they were or where they are, up to 16 at a time.
  void find_overlapping_either(std::span<const OrderedBox> before,
                               std::span<const OrderedBox> after, Lookup& lookup,
                               std::vector<MoverHit>& out) const;

  /// Visits the boxes along a ray, as bvh::walk_along() says.
  void walk_along(const RaySlabs& ray, double& limit, const RayVisitor& visit) const;

  /// Boxes that came, or went far, since the last refit.
  std::size_t arrivals() const { return arrivals_; }
  std::uint64_t sorts() const { return sorts_; }
  std::uint64_t groups_sorted() const { return groups_sorted_; }
  std::uint64_t blocks_met() const { return met_; }
  std::size_t bytes() const;
  int layer_count() const { return static_cast<int>(layers_.size()); }
  TreeView view(int layer) const;

 private:
  struct Scratch {
    std::vector<bool> is_named;  ///< by place
    RankedProxies ranked;
    std::vector<BlockPair> tasks, next_tasks;
    std::vector<PairBuffer> found;
    std::vector<std::uint64_t> met;
    std::vector<double> sums;
  };

  /// What a sort needs besides the boxes, and gives back: sorts are rare, memory is not.
  struct SortSpace {
    std::vector<KdItem> items;
    std::vector<std::uint32_t> starts;  ///< of the layers' items, and the end
    std::vector<std::uint8_t> layer_of_class;
    std::vector<Layer> layers;
    std::vector<Block> high;
    std::vector<LowBlock> low;
    std::vector<std::uint32_t> proxy;
  };

  /// A block of the level above those of boxes, below which a hole was filled.
  struct FilledGroup {
    std::uint32_t layer;
    std::uint32_t block;
  };

  /// Of a group of 16 blocks: where each place within it is to go, a block within it.
  using GroupBlocks = std::array<std::uint8_t, kLanes * kLanes>;

  std::size_t layer_of(std::uint32_t block) const;
  OrderedBox box_at(std::uint32_t place) const {
    return lane_box(high_[place >> kLaneBits], low_[place >> kLaneBits], place & (kLanes - 1));
  }
  std::uint32_t empty_place(std::uint32_t block) const;
  void take(std::uint32_t place, std::uint32_t proxy, const OrderedBox& box);
  void append(std::uint32_t proxy, const OrderedBox& box);
  bool leaves_neighbours(const Layer& layer, std::uint32_t block, const OrderedBox& box) const;
  bool fill_hole(std::uint32_t proxy, const OrderedBox& box);
  bool has_room_for_one();
  void touch(std::uint32_t block);
  void list_tasks(std::size_t wanted);
  std::uint64_t find_below(std::span<const BlockPair> tasks, PairBuffer& out) const;
  void find_in_parallel(PairBuffer& out);
  double predicted_excess() const;
  void refit_every_layer();
  void refit_touched();
  void move_outliers();
  bool move_outlier(std::size_t layer, std::uint32_t block);
  void sort_newcomers();
  void sort_groups();
  void sort_group(Layer& layer, std::uint32_t group);
  void regroup(std::uint32_t base, const GroupBlocks& block_of);
  double inflation_of_group(const Layer& layer, std::uint32_t first) const;
  std::vector<KdItem> sample_centres(const double* origin) const;
  std::vector<std::uint8_t> choose_layers(std::span<const std::uint32_t> count_of_class,
                                          const double* origin) const;
  void collect_items(SortSpace& space) const;
  void make_room_for_items(SortSpace& space) const;
  void place_items(SortSpace& space);
  void move_ranked(std::span<const Aabb> boxes);
  void move_named(std::span<const Aabb> boxes);
  template <typename InputOf>
  void fill_blocks(std::span<const Aabb> boxes, const InputOf& input_of);
  void measure_sorted();

  std::vector<Block> high_;
  std::vector<LowBlock> low_;
  std::vector<std::uint32_t> proxy_;  ///< by position: 16 times the block plus the lane
  std::vector<std::uint32_t> place_;  ///< by proxy: the position
  std::vector<Layer> layers_;         ///< by size class; the last holds what came since the sort
  std::vector<std::uint8_t> layer_of_class_;  ///< of sizes, as of the last sort; kNoLayer if new
  std::vector<FilledGroup> filled_;
  std::vector<std::uint32_t> touched_;
  std::vector<std::uint32_t> touched_here_;
  std::size_t size_ = 0;
  std::size_t newcomers_ = 0;         ///< positions of the last layer that are or were taken
  std::size_t sorted_newcomers_ = 0;  ///< how many they were when they were last put in order
  std::size_t holes_ = 0;
  std::size_t moves_ = 0;            ///< one by one, since the last refit
  std::size_t arrivals_ = 0;         ///< since the last refit: new, or left their neighbours
  std::size_t arrivals_before_ = 0;  ///< between that and the one before
  bool all_touched_ = false;
  Workers workers_;

  std::uint64_t sorts_ = 0;
  std::uint64_t groups_sorted_ = 0;
  std::uint64_t met_ = 0;         ///< pairs of blocks met in the last search for all pairs
  std::uint64_t met_sorted_ = 0;  ///< the same, in the first search after the last sort
  double excess_ = 0;             ///< pairs of blocks met since then beyond that number
  double inflation_ = 0;          ///< summed over blocks, kept up by refit() of paths
  Scratch scratch_;
};

}  // namespace graze::bvh
