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

/// What an update did.
struct BroadPhaseWork {
  std::uint64_t updates = 0;              ///< calls of BroadPhase::update()
  std::uint64_t searches_for_all = 0;     ///< updates that looked for all pairs anew
  std::uint64_t searches_for_movers = 0;  ///< updates that looked at movers only
  std::uint64_t sorts = 0;                ///< times that all boxes were put into a new order
  std::uint64_t groups_sorted = 0;  ///< times that up to 256 neighbours were put into a new order
  std::uint64_t blocks_met =
      0;  ///< pairs of blocks of 16 boxes that the last search for all pairs compared

  bool operator==(const BroadPhaseWork&) const = default;
};

/// How a BroadPhase works.
struct BroadPhaseSettings {
  /// How many threads share an update at most; 0: all that there are, of which 256 are used. No
  /// result depends on it.
  int threads = 1;
};

/// Is told of a box that a ray may meet, by index; returns the distance along the ray, metres,
/// beyond which no more boxes are of interest.
using RayBoxVisitor = std::function<double(std::uint32_t index)>;

/// Which of many moving boxes overlap: exactly, on their own doubles, touching included.
///
///   BroadPhase boxes;
///   BoxId a = boxes.add(box_a), b = boxes.add(box_b);
///   boxes.move(a, elsewhere);
///   boxes.update();
///   for (BoxPair pair : boxes.pairs()) ...
///
/// `add`, `move` and `remove` are seen by queries at once and by pairs(), begun() and ended() from
/// the next update() on. An update costs what moved and what that changed: nothing if nothing did.
/// The first query after changes costs what they touched, as the update would: after one change
/// about a microsecond, after very many a sort; box() and the queries after it do not wait. Queries
/// at the same time wait for that first one.
/// What throws for want of memory (std::bad_alloc) has not happened: of an update the pairs are
/// those of before, none began or ended, and the next one tells all that has since. All lists are
/// the same for any number of threads and on any SIMD target. Spans are valid until the next
/// update(): boxes may come, move and go while a loop reads them. Const functions may run at the
/// same time.
class BroadPhase {
 public:
  /// It begins without boxes.
  explicit BroadPhase(const BroadPhaseSettings& settings = {});
  ~BroadPhase();
  BroadPhase(BroadPhase&&) noexcept;
  BroadPhase& operator=(BroadPhase&&) noexcept;

  /// Throws InputError for a box that is not finite or whose minimum exceeds its maximum.
  BoxId add(const Aabb& box);

  /// Gives boxes a new place. Throws StaleIdError, InputError; of a span that throws no box has
  /// moved. The last of equal ids counts. One call with many is cheaper than many calls.
  void move(BoxId id, const Aabb& box);
  void move(std::span<const BoxId> ids, std::span<const Aabb> boxes);

  /// Throws StaleIdError. The index is not given out again before two more updates.
  void remove(BoxId id);

  std::size_t size() const;
  /// Whether the id is of a box that is there.
  bool contains(BoxId id) const;
  /// Where it was put last. Throws StaleIdError.
  Aabb box(BoxId id) const;
  /// The id of the box with this index. Throws StaleIdError.
  BoxId id(std::uint32_t index) const;

  /// Finds which pairs overlap now.
  void update();

  /// All pairs that overlap, each once, by index, smaller first. The order is the same for the same
  /// history of calls, queries among them.
  std::span<const BoxPair> pairs() const;

  /// The same in ascending order. O(pairs) when first asked after an update that changed any.
  std::span<const BoxPair> sorted_pairs();

  /// Pairs that overlap since the last update, and that do not any more, each list in ascending
  /// order. A removed box is still known by its index here. After an update that searched all, the
  /// first call costs O(pairs).
  std::span<const BoxPair> begun();
  std::span<const BoxPair> ended();

  /// Appends the indices of all boxes that share a point with `box`, in an order of no meaning.
  void find_overlapping(const Aabb& box, std::vector<std::uint32_t>& indices) const;

  /// Calls `visit` once for each box that the ray meets before that distance, and perhaps for some
  /// that it misses by less than 2^-36 of how far they reach from its origin; those near its origin
  /// roughly first. `visit` must not change the boxes. Throws as check_ray() does.
  void visit_along(const Ray& ray, const RayBoxVisitor& visit) const;

  /// What updates have done since the beginning.
  const BroadPhaseWork& work() const;

  /// Memory in use, bytes: for the boxes, and for lists of pairs and what finds changes in them,
  /// such as where boxes were that moved. From 10,000 boxes on the former is at most 64 a box on
  /// one thread, however they are moved; while many come and go a few more.
  std::size_t bytes_for_boxes() const;
  std::size_t bytes_for_pairs() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
