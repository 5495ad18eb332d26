#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/error.h>
#include <graze/bvh/ray.h>
#include <graze/engine/world/ids.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace graze {

/// Counts of what updates did.
struct BroadPhaseWork {
  std::uint64_t updates = 0;              ///< the number of calls of BroadPhase::update()
  std::uint64_t searches_for_all = 0;     ///< the number of updates that looked for all pairs anew
  std::uint64_t searches_for_movers = 0;  ///< the number of updates that looked at movers only
  std::uint64_t sorts = 0;                ///< how often all boxes were put into a new order
  std::uint64_t groups_sorted = 0;  ///< how often up to 256 neighbours were put into a new order
  std::uint64_t blocks_met =
      0;  ///< the number of pairs of blocks of 16 boxes that the last search for all pairs compared

  bool operator==(const BroadPhaseWork&) const = default;
};

/// The settings of a BroadPhase.
struct BroadPhaseSettings {
  /// At most so many threads share an update; 0 means all threads of the machine, but no more than
  /// 256. No result depends on it.
  int threads = 1;
};

/// A function that is called with the index of a box that a ray may meet. It returns the distance
/// along the ray, metres, beyond which no more boxes are of interest.
using RayBoxVisitor = std::function<double(std::uint32_t index)>;

/// Finds which of many moving boxes overlap: exactly, on the boxes' own doubles, and boxes that
/// only touch count.
///
///   BroadPhase boxes;
///   BoxId a = boxes.add(box_a), b = boxes.add(box_b);
///   boxes.move(a, elsewhere);
///   boxes.update();
///   for (BoxPair pair : boxes.pairs()) ...
///
/// Queries see `add`, `move` and `remove` at once; pairs(), begun() and ended() see them from the
/// next update() on. The cost of an update grows with the boxes that moved and the pairs that this
/// changed: it is nothing if nothing moved. The first query after changes does the work that the
/// update would do for them: about a microsecond after one change, and a sort after very many.
/// Queries and box() at the same time wait for that first one; after it none waits. A call
/// that throws for want of memory (std::bad_alloc) changes nothing: after such an update the pairs
/// are those of before, none began or ended, and the next update lists all that has changed since.
/// All lists are the same for any number of threads and on any SIMD target. Spans are valid until
/// the next update(): boxes may come, move and go while a loop reads them. Const functions may run
/// at the same time; while one changes the broad phase no other may.
class BroadPhase {
 public:
  /// Makes a broad phase without boxes.
  explicit BroadPhase(const BroadPhaseSettings& settings = {});
  ~BroadPhase();
  BroadPhase(BroadPhase&&) noexcept;
  BroadPhase& operator=(BroadPhase&&) noexcept;

  /// Adds a box. Throws InputError for one that is not finite or whose minimum exceeds its maximum.
  BoxId add(const Aabb& box);

  /// Gives boxes a new place. Throws StaleIdError, and InputError as add() does; a call that throws
  /// has moved no box. Of equal ids the last one counts. One call with many boxes is cheaper than
  /// many calls.
  void move(BoxId id, const Aabb& box);
  void move(std::span<const BoxId> ids, std::span<const Aabb> boxes);

  /// Removes a box. Throws StaleIdError. The index is not given out again before two more updates.
  void remove(BoxId id);

  std::size_t size() const;
  /// True if the broad phase has a box with this id.
  bool contains(BoxId id) const;
  /// Returns the box as it was given last. Throws StaleIdError.
  Aabb box(BoxId id) const;
  /// Returns the id of the box with this index. Throws StaleIdError.
  BoxId id(std::uint32_t index) const;

  /// Finds which pairs overlap now.
  void update();

  /// Returns all pairs that overlap, each once, as two indices, the smaller one first. The order is
  /// the same for the same history of calls, queries among them.
  std::span<const BoxPair> pairs() const;

  /// Returns the same pairs in ascending order. The first call after an update that changed any
  /// costs O(pairs).
  std::span<const BoxPair> sorted_pairs();

  /// Return the pairs that began to overlap in the last update, and those that ended, each list in
  /// ascending order. A removed box is still named by its index here. After an update that looked
  /// for all pairs anew the first call costs O(pairs).
  std::span<const BoxPair> begun();
  std::span<const BoxPair> ended();

  /// Appends the indices of all boxes that share a point with `box`, in no particular order.
  void find_overlapping(const Aabb& box, std::vector<std::uint32_t>& indices) const;

  /// Calls `visit` once for each box that the ray meets before ray.max_distance at first, and
  /// then before the distance that `visit` returned last, and perhaps for some that the ray misses
  /// by less than 2^-36 of how far they reach from its origin. Boxes near the origin come first,
  /// roughly. `visit` must not change the boxes. Throws as check_ray() does.
  void visit_along(const Ray& ray, const RayBoxVisitor& visit) const;

  /// Returns what updates have done since the beginning.
  const BroadPhaseWork& work() const;

  /// Return the memory in use, bytes: for the boxes; and for lists of pairs and for what finds
  /// changes in them, such as the old places of boxes that moved. With 10,000 boxes or more the
  /// boxes take at most 64 bytes each on one thread, however they are moved, and a few more while
  /// many come and go.
  std::size_t bytes_for_boxes() const;
  std::size_t bytes_for_pairs() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
