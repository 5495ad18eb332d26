#pragma once

#include <graze/bvh/box_set/order/kd_order.h>
#include <graze/bvh/box_set/store/box_store.h>
#include <graze/bvh/box_set/store/workers.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Decides in which order the boxes of a store share blocks: which place a box takes that comes or
/// moves, and when and how boxes are sorted anew. It keeps the bounds above them.
class BoxOrder {
 public:
  BoxOrder(BoxStore& store, const Workers& workers) : store_(store), workers_(workers) {}

  void insert(std::uint32_t proxy, const OrderedBox& box);
  void move(std::uint32_t proxy, const OrderedBox& box);

  /// Makes the bounds fit the boxes again, moves outliers and sorts groups that were stretched.
  /// Only dirty blocks take time, unless many moved at once: then all do.
  void refit_and_regroup();

  /// Refits, and orders the boxes anew if many came: this prepares for queries.
  void prepare_for_queries();

  /// Refits, and orders all boxes anew if the old order has cost more by now than that does. What
  /// the search for all pairs that follows would cost counts as well.
  void prepare_for_search();

  /// Refits, and orders all boxes anew, or those that came since the last sort, if so many lookups
  /// as follow would otherwise cost more than that.
  void prepare_for_lookups(std::size_t lookups);

  /// Notes that a search for all pairs met so many pairs of blocks: those beyond what the first
  /// search after the last sort met are the cost of the order by now.
  void note_search(std::uint64_t met);

  /// Returns how many boxes came, or went far, since the last refit.
  std::size_t arrivals() const { return arrivals_; }
  std::uint64_t sorts() const { return sorts_; }
  std::uint64_t groups_sorted() const { return groups_sorted_; }
  std::size_t bytes() const { return filled_.capacity() * sizeof(FilledGroup); }

 private:
  /// The memory that a sort needs besides the boxes, and gives back: sorts are rare, memory is not.
  struct SortSpace {
    std::vector<KdItem> items;
    std::vector<std::uint32_t> starts;  ///< where each layer's items begin, and the end
    std::vector<std::uint8_t> layer_of_class;
    std::vector<Layer> layers;
    std::vector<Block> high;
    std::vector<LowBlock> low;
    std::vector<std::uint32_t> proxies;
  };

  /// A block of the level above those of boxes, below which a hole was filled.
  struct FilledGroup {
    std::uint32_t layer;
    std::uint32_t block;
  };

  /// A block that has grown much since it was sorted.
  struct StretchedBlock {
    std::size_t layer;
    std::uint32_t block;  ///< the number of the block in its layer
  };

  /// For each place in a group of 16 blocks, the block of the group to which its box is to go.
  using GroupBlocks = std::array<std::uint8_t, kLanes * kLanes>;

  bool leaves_neighbours(const Layer& layer, std::uint32_t block, const OrderedBox& box) const;
  bool fill_hole(std::uint32_t proxy, const OrderedBox& box);
  void sort();
  double predicted_order_cost() const;
  void refit_every_layer();
  void refit_dirty();
  void move_outliers();
  bool move_outlier(std::size_t layer, std::uint32_t block);
  void sort_newcomers();
  void sort_groups();
  void sort_group(Layer& layer, std::uint32_t group);
  void regroup(std::uint32_t base, const GroupBlocks& block_of);
  double degradation_of_group(const Layer& layer, std::uint32_t first) const;
  std::vector<KdItem> sample_centres(const double* origin) const;
  std::vector<std::uint8_t> choose_layers(std::span<const std::uint32_t> count_of_class,
                                          const double* origin) const;
  void collect_items(SortSpace& space) const;
  void make_room_for_items(SortSpace& space) const;
  void place_items(SortSpace& space);
  void measure_sorted();

  BoxStore& store_;
  const Workers& workers_;
  std::vector<std::uint8_t> layer_of_class_;   ///< layers of size classes, as of the last sort;
                                               ///< kNoLayer if new
  std::vector<FilledGroup> filled_;            ///< groups that were filled since the last refit
  std::vector<std::uint32_t> dirty_of_layer_;  ///< working memory: dirty blocks of one layer
  std::vector<StretchedBlock> stretched_;      ///< working memory
  std::vector<double> sums_;                   ///< working memory: degradation by chunks of blocks
  std::size_t sorted_newcomers_ = 0;  ///< how many newcomers were when they were last put in order
  std::size_t moves_ = 0;             ///< boxes moved one by one since the last refit
  std::size_t arrivals_ = 0;          ///< boxes since the last refit that are new, or left their
                                      ///< neighbours
  std::size_t arrivals_before_ = 0;   ///< arrivals between that refit and the one before

  std::uint64_t sorts_ = 0;
  std::uint64_t groups_sorted_ = 0;
  std::uint64_t met_sorted_ = 0;  ///< pairs of blocks met in the first search after the last sort
  double order_cost_ =
      0;  ///< what the old order has cost: pairs of blocks met since then beyond that number
  double degradation_ =
      0;  ///< summed over blocks (degradation() in layer.h), kept up by refit_and_regroup()
};

}  // namespace graze::bvh
