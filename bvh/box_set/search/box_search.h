#pragma once

#include <graze/bvh/box_set/search/pair_kernels.h>
#include <graze/bvh/box_set/search/ray_walk.h>
#include <graze/bvh/box_set/store/box_store.h>
#include <graze/bvh/box_set/store/workers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Searches the boxes of a store, whose bounds must fit: for all pairs that overlap, for what
/// overlaps single boxes, for what lies along a ray.
class BoxSearch {
 public:
  BoxSearch(const BoxStore& store, const Workers& workers) : store_(store), workers_(workers) {}

  /// Finds all pairs that overlap, each once, in an order that the history of the store decides.
  /// Returns how many pairs of blocks it met.
  std::uint64_t find_all_pairs(PairBuffer& out);

  /// Appends the proxies of all boxes that overlap `box`.
  void find_overlapping(const OrderedBox& box, std::vector<std::uint32_t>& out) const;

  /// Appends what overlaps movers where they were or where they are, up to 16 at a time.
  void look_up_movers(std::span<const OrderedBox> before, std::span<const OrderedBox> after,
                      Lookup& lookup, std::vector<MoverOverlap>& out) const;

  /// Visits the boxes along a ray, as bvh::walk_along() says.
  void walk_along(const RaySlabs& ray, double& limit, const RayVisitor& visit) const;

  /// Returns how many pairs of blocks the last search for all pairs met.
  std::uint64_t blocks_met() const { return met_; }
  std::size_t bytes() const;

 private:
  void list_tasks(std::size_t wanted);
  std::uint64_t find_below(std::span<const BlockPair> tasks, PairBuffer& out) const;
  std::uint64_t find_in_parallel(PairBuffer& out);
  TreeView view(std::uint32_t layer) const { return store_.view(layer); }

  const BoxStore& store_;
  const Workers& workers_;
  std::uint64_t met_ = 0;
  std::vector<BlockPair> tasks_, next_tasks_;
  std::vector<PairBuffer> found_of_;   ///< the pairs that each chunk of tasks found
  std::vector<std::uint64_t> met_of_;  ///< how many pairs of blocks each chunk met
};

}  // namespace graze::bvh
