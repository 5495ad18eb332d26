// The leaves of a front in a pass. Included once for each SIMD target.

#if defined(GRAZE_BVH_FRONT_LEAVES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_FRONT_LEAVES
#undef GRAZE_BVH_FRONT_LEAVES
#else
#define GRAZE_BVH_FRONT_LEAVES
#endif

#include <graze/bvh/wide/front/front_due-inl.h>
#include <graze/bvh/wide/front/local_leaves-inl.h>
#include <graze/bvh/wide/front/primitive_gaps-inl.h>
#include <graze/bvh/wide/lanes/leaf_crossings-inl.h>

#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// What a pass does with the leaves of a front: it finds which of their primitives meet, or are
/// near, and planes that keep the others apart.
template <FrontBounds bounds>
class FrontLeaves : protected FrontDue<bounds> {
 protected:
  using Base = FrontDue<bounds>;
  using Base::budget_after;
  using Base::fetch;
  using Base::find_due;
  using Base::must_;
  using Base::outlook_;
  using Base::pass_;
  using Base::planes_;
  using Base::state_;
  using typename Base::LeafPlanes;
  using typename Base::Outlook;

  FrontLeaves(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task)
      : Base(state, pass, task), leaves_(*state.tree[0], *state.tree[1]) {}

  /// Compares leaves that are due: which of their primitives may be within the limit.
  HWY_INLINE void compare_due_leaves() {
    const std::size_t near = find_due(planes_.of_leaves, state_.leaves_budgets);
    state_.looked_at += near;
    for (std::size_t i = 0; i < near; ++i)
      compare_leaves(state_.due[i]);
  }

  /// Decides which primitives of leaves that are busy or due meet. In which leaves some do cannot
  /// be predicted, so that no branch depends on it.
  HWY_INLINE void decide_leaves() {
    state_.crossing.size = 0;
    state_.unsure.size = 0;
    separate_leaves(decide_busy());
    const std::size_t near = find_due(planes_.of_leaves, state_.leaves_budgets);
    state_.looked_at += near;
    separate_leaves(near);
  }

  /// Decides all pairs of leaves that have been busy. Those in which no primitives meet any more
  /// are listed at the front of state_.due; returns how many these are.
  HWY_INLINE std::size_t decide_busy() {
    const std::size_t size = state_.busy.size();
    state_.crossing.make_room(size);
    state_.unsure.make_room(size);
    if (state_.due.size() < size) state_.due.resize(2 * size);
    std::size_t busy = 0;
    std::size_t quiet = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (i + 2 * kAhead < size) fetch(state_.leaves[state_.busy[i + 2 * kAhead]]);
      if (i + kAhead < size) fetch_leaves(state_.busy[i + kAhead]);
      const std::uint32_t index = state_.busy[i];
      const std::uint32_t asked = set_leaves(state_.leaves[index]);
      state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
      const PairTag tag;
      Meetings found;
      for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
        const LocalPairs<PairTag> pairs(leaves_, first);
        found.add(LeafCrossings<PairTag>(pairs, leaves_.errors().of_pairs(tag)), first);
      }
      const std::uint32_t open = list(index, asked, found);
      state_.busy[busy] = index;
      state_.due[quiet] = index;
      busy += open != 0;
      quiet += open == 0;
    }
    state_.busy.resize(busy);
    return quiet;
  }

  /// Finds planes between the primitives of the first `count` leaves of state_.due. Those with
  /// pairs that no plane tells apart become busy.
  HWY_NOINLINE void separate_leaves(std::size_t count) {
    state_.crossing.make_room(count);
    state_.unsure.make_room(count);
    std::size_t busy = state_.busy.size();
    state_.busy.resize(busy + count);
    for (std::size_t i = 0; i < count; ++i) {
      if (i + 2 * kAhead < count) {
        fetch(state_.leaves[state_.due[i + 2 * kAhead]]);
        fetch(planes_.of_leaves[state_.due[i + 2 * kAhead]]);
      }
      if (i + kAhead < count) fetch_leaves(state_.due[i + kAhead]);
      const std::uint32_t index = state_.due[i];
      const WideFront::Leaves& leaves = state_.leaves[index];
      LeafPlanes& planes = planes_.of_leaves[index];
      const std::uint32_t asked = set_leaves(leaves);
      state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
      const PairTag tag;
      Meetings met;
      FoundPlanes<kLeafPairs> gaps;
      for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
        const LocalPairs<PairTag> pairs(leaves_, first);
        const LeafCrossings<PairTag> crossings(pairs, leaves_.errors().of_pairs(tag));
        met.add(crossings, first);
        PrimitiveGaps<PairTag> found(pairs, leaves_.errors().offset);
        found.look_at(crossings);
        const auto is_open = hn::Not(hn::Or(found.are_apart(), crossings.do_cross));
        if ((bits_of(tag, is_open) & asked >> first) != 0) found.look_across();
        found.store(planes, gaps, first, pass_.units[leaves.tested_side]);
      }
      const typename Outlook::Nearness found =
          outlook_[leaves.tested_side].keep(planes, gaps, asked, must_.limit);
      // What planes keep apart does not meet, be it unsure or not.
      list(index, found.near, met);
      const std::uint32_t is_busy = found.near != 0;
      state_.leaves_budgets[index] = chosen(is_busy, kNever, budget_after(found.lasts));
      state_.busy[busy] = index;
      busy += is_busy;
    }
    state_.busy.resize(busy);
  }

 private:
  /// Leaves of large meshes are not in the cache.
  HWY_INLINE void fetch_leaves(std::size_t index) const {
    const WideFront::Leaves& leaves = state_.leaves[index];
    fetch_leaf(leaves.tested_side, leaves.tested);
    fetch_leaf(1 - leaves.tested_side, leaves.query);
  }

  HWY_INLINE void fetch_leaf(int side, const WideFront::Leaf& leaf) const {
    constexpr std::size_t kLine = 64 / sizeof(float);
    const float* rows = rows_of(state_.tree[side]->treelet(leaf.treelet), leaf.link);
    for (std::size_t i = 0; i < CornerRows::kRows * ChildLink::kMaxLeafSize; i += kLine)
      hwy::Prefetch(rows + i);
  }

  /// Sets leaves_. Returns the bits of the pairs that it has.
  HWY_INLINE std::uint32_t set_leaves(const WideFront::Leaves& leaves) {
    leaves_.set(leaves, pass_.into[leaves.tested_side]);
    return leaves_.pairs();
  }

  HWY_INLINE static void add_lanes(WideFront::LeafPairs& pairs, std::uint32_t leaves,
                                   std::uint32_t lanes) {
    const hn::CappedTag<std::uint32_t, kLeafPairs> tag;
    std::uint32_t* const end = pairs.lanes.data();
    for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
      const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes >> first),
                                    static_cast<std::uint8_t>(lanes >> first >> 8)};
      const auto code = static_cast<std::uint32_t>(kLeafPairs * leaves + first);
      pairs.size += hn::CompressStore(hn::Iota(tag, code), hn::LoadMaskBits(tag, bits), tag,
                                      end + pairs.size);
    }
  }

  /// Which pairs of two leaves surely cross, and which are surely apart.
  struct Meetings {
    std::uint32_t crossing = 0;
    std::uint32_t apart = 0;

    HWY_INLINE void add(const LeafCrossings<PairTag>& some, std::size_t first) {
      crossing |= bits_of(PairTag(), some.do_cross) << first;
      apart |= bits_of(PairTag(), some.are_apart) << first;
    }
  };

  /// Lists those pairs of leaves_ that cross or may cross, and returns their bits.
  HWY_INLINE std::uint32_t list(std::uint32_t index, std::uint32_t asked, const Meetings& found) {
    const std::uint32_t open = asked & ~found.apart;
    add_lanes(state_.crossing, index, open & found.crossing);
    if ((open & ~found.crossing) != 0) add_lanes(state_.unsure, index, open & ~found.crossing);
    return open;
  }

  HWY_INLINE void compare_leaves(std::size_t index) {
    WideFront::Leaves& leaves = state_.leaves[index];
    LeafPlanes& planes = planes_.of_leaves[index];
    const std::uint32_t asked = set_leaves(leaves) & ~leaves.listed;
    state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
    const PairTag tag;
    FoundPlanes<kLeafPairs> gaps;
    for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
      const LocalPairs<PairTag> pairs(leaves_, first);
      const LeafCrossings<PairTag> crossings(pairs, leaves_.errors().of_pairs(tag));
      PrimitiveGaps<PairTag> found(pairs, leaves_.errors().offset);
      found.look_at(crossings);
      found.look_along(pass_.direction[leaves.tested_side]);
      found.store(planes, gaps, first, pass_.units[leaves.tested_side]);
    }
    const typename Outlook::Nearness found =
        outlook_[leaves.tested_side].keep(planes, gaps, asked, must_.limit);
    state_.leaves_budgets[index] = budget_after(found.lasts);
    leaves.listed |= found.near;
    for (std::uint32_t near = found.near; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      state_.candidates.push_back(static_cast<std::uint32_t>(kLeafPairs * index) + lane);
    }
    state_.candidate_budgets.resize(state_.candidates.size(), kAtOnce);
    state_.candidate_planes.resize(state_.candidates.size());
  }

  LocalLeaves leaves_;
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
