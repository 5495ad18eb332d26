#pragma once

#include <graze/bvh/box_set/box_changes.h>
#include <graze/bvh/box_set/box_set.h>
#include <graze/bvh/box_set/former_boxes.h>
#include <graze/bvh/box_set/pair_index.h>
#include <graze/bvh/box_set/pair_rows.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// A box set, the list of its overlapping pairs, and what the last update changed in that list.
///
/// With few changes the list is edited: a box that changed is looked up where it was and where it
/// is. The difference is what began and what ended. With many changes all pairs are searched anew,
/// and what changed is worked out if somebody asks.
class OverlapTracker {
 public:
  explicit OverlapTracker(int threads) : set_(threads) {}

  const BoxSet& set() const { return set_; }

  /// Moves boxes now; the pairs follow with the next update. All must be in the set.
  void move_now(std::span<const std::uint32_t> owners, std::span<const Aabb> boxes);
  void move_first_now(std::span<const Aabb> boxes);
  template <typename OwnerOf>
  void move_ascending_now(std::span<const Aabb> boxes, const OwnerOf& owner_of) {
    set_.move_ascending(boxes, owner_of);
    end_moves();
  }

  /// True if so many changes are handled by a search for all pairs.
  bool are_many(std::size_t changes) const;

  /// Uses the changes up. False if there was nothing to do.
  bool update(BoxChanges& changes);

  std::span<const BoxPair> pairs() const { return pairs_.pairs(); }
  std::span<const BoxPair> sorted_pairs();
  std::span<const BoxPair> begun();
  std::span<const BoxPair> ended();

  std::uint64_t searches_for_all() const { return searches_for_all_; }
  std::uint64_t searches_for_movers() const { return searches_for_movers_; }
  std::size_t bytes_for_pairs() const;

 private:
  struct Mover {
    std::uint32_t place;   // where the box lies in the set: neighbours are looked up together
    std::uint32_t change;  // which entry of the changes
  };

  void end_moves();
  void apply(const BoxChanges& changes);
  void search_all(BoxChanges& changes);
  void search_movers(const BoxChanges& changes);
  void compare_places(const BoxChanges& changes);
  void look_up_some(const BoxChanges& changes, std::size_t first);
  void end_pairs_of_movers();
  void edit_list();
  void list_movers(const BoxChanges& changes);
  void work_out_difference();

  BoxSet set_;
  PairBuffer pairs_;
  PairBuffer before_;  // the list before the last search for all
  PairIndex index_;    // of pairs_, while it is built
  PairBuffer sorted_;
  bool is_sorted_ = false;  // sorted_ holds pairs_
  PairRows rows_, rows_before_;
  bool is_grouped_ = false;         // rows_ holds pairs_
  bool is_before_grouped_ = false;  // rows_before_ holds before_
  RowsToSort rows_to_sort_;
  bool has_difference_ = true;  // begun_ and ended_ are up to date
  bool all_moved_ = false;
  PairBuffer begun_, ended_;
  std::vector<std::uint32_t> starts_;
  std::vector<Mover> movers_;
  std::vector<bool> is_mover_;            // by owner
  std::vector<OrderedBox> boxes_before_;  // by mover
  FormerBoxes former_;                    // the same as a tree
  PairBuffer former_pairs_;
  std::vector<MoverHit> hits_;
  Lookup lookup_;
  std::uint64_t searches_for_all_ = 0;
  std::uint64_t searches_for_movers_ = 0;
};

}  // namespace graze::bvh
