#pragma once

#include <graze/bvh/box_set/box_set.h>
#include <graze/bvh/box_set/former_boxes.h>
#include <graze/bvh/box_set/search/pair_index.h>
#include <graze/bvh/box_set/search/pair_lists.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// A box set, the list of its overlapping pairs, and what the last update changed in that list.
///
/// Boxes change when a ninth change comes, or before a query or an update; the list changes with
/// the next update. With few changes the list is edited: a box that changed is looked up where it
/// was and where it is. The difference is what began and what ended. With many changes all pairs
/// are searched anew, and what changed is worked out if somebody asks.
class OverlapTracker {
 public:
  explicit OverlapTracker(int threads) : set_(threads) {}

  /// Returns the set as of the last prepare_for_queries(), update() or make_waiting_changes(): a
  /// few changes may wait.
  const BoxSet& set() const { return set_; }

  /// Change a box as BoxOrder::insert(), BoxOrder::move() and BoxStore::erase() do. Of these
  /// insert() alone may throw, and has then not happened. A proxy that is erased must not come
  /// again before the next update.
  void insert(std::uint32_t proxy, const Aabb& box);
  void move(std::uint32_t proxy, const Aabb& box);
  void erase(std::uint32_t proxy);

  /// Makes the changes that wait for their blocks to be fetched.
  void make_waiting_changes();

  /// True if so many changes are handled by a search for all pairs.
  bool are_many(std::size_t changes) const;

  /// Move many boxes as ManyMoves does. All of them count as changed: a search for all pairs
  /// follows.
  void move_first(std::span<const Aabb> boxes) {
    make_waiting_changes();
    count_all_as_changed();
    set_.many_moves().move_first(boxes);
  }
  template <typename ProxyOf>
  void move_ascending(std::span<const Aabb> boxes, const ProxyOf& proxy_of) {
    make_waiting_changes();
    count_all_as_changed();
    set_.many_moves().move_ascending(boxes, proxy_of);
  }
  template <typename ProxyOf>
  void move_many(std::span<const Aabb> boxes, const ProxyOf& proxy_of) {
    make_waiting_changes();
    count_all_as_changed();
    set_.many_moves().move(boxes, proxy_of);
  }

  /// Makes the set ready for queries. No list changes.
  void prepare_for_queries() {
    make_waiting_changes();
    set_.order().prepare_for_queries();
  }

  /// Makes the lists fit the boxes. Returns false if there was nothing to do. If it throws, the
  /// list of pairs is the one of before, nothing began or ended, and the next update tells what has
  /// since then.
  bool update();

  std::span<const BoxPair> pairs() const { return pairs_.pairs(); }
  std::span<const BoxPair> sorted_pairs();
  std::span<const BoxPair> begun();
  std::span<const BoxPair> ended();

  std::uint64_t searches_for_all() const { return searches_for_all_; }
  std::uint64_t searches_for_movers() const { return searches_for_movers_; }
  std::size_t bytes_for_pairs() const;

 private:
  /// A box that has changed since the last update, as it was then.
  struct ChangedBox {
    OrderedBox before;    ///< no_box() for one that is new
    std::uint32_t place;  ///< its place in the set; kNullIndex for one that is new
    std::uint32_t proxy;
  };
  enum class Verb { Insert, Move, Erase };
  struct WaitingChange {
    Verb verb;
    std::uint32_t proxy;
    Aabb box;
  };
  struct Mover {
    std::uint32_t place;    ///< its place now, or where it was if it is gone
    std::uint32_t changed;  ///< its index in changed_
  };

  const ChangedBox& changed_box_of(const Mover& mover) const { return changed_[mover.changed]; }
  std::size_t most_changes() const;
  void hold(const WaitingChange& change);
  void note(std::uint32_t proxy);
  void note_one(std::uint32_t proxy);
  void count_all_as_changed();
  void forget_changes();
  void search_all();
  void search_movers();
  void look_up_all();
  void look_up_some(std::size_t first);
  void end_pairs_of_movers();
  void edit_list();
  void list_former_boxes();
  void list_movers();
  void sort_movers();
  void work_out_difference();

  BoxSet set_;
  PairBuffer pairs_;
  PairBuffer before_;  ///< the list before the last search for all
  PairIndex index_;    ///< the places of pairs in pairs_, while it is built
  PairBuffer sorted_;
  bool is_sorted_ = false;  ///< whether sorted_ holds pairs_
  PairRows rows_, rows_before_;
  bool is_grouped_ = false;         ///< whether rows_ holds pairs_
  bool is_before_grouped_ = false;  ///< whether rows_before_ holds before_
  RowsToSort rows_to_sort_;
  bool has_difference_ = true;  ///< whether begun_ and ended_ are up to date
  bool is_difference_sorted_ = true;
  PairBuffer begun_, ended_;
  static constexpr std::size_t kMostWaiting = 8;
  std::array<WaitingChange, kMostWaiting> waiting_;
  std::size_t waiting_count_ = 0;
  std::vector<ChangedBox> changed_;  ///< the boxes that changed, while they are few
  std::vector<bool> is_changed_;     ///< for each proxy, whether it is in changed_
  bool have_many_changed_ = false;
  std::vector<std::uint32_t> ends_;  ///< working memory of sort_pairs()
  std::vector<Mover> movers_;
  FormerBoxes former_;  ///< the places where movers were
  PairBuffer former_pairs_;
  std::vector<MoverOverlap> overlaps_;
  Lookup lookup_;
  std::uint64_t searches_for_all_ = 0;
  std::uint64_t searches_for_movers_ = 0;
};

}  // namespace graze::bvh
