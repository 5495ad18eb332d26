// This compares the leaves of a front in a pass: which of their primitives meet, and how far apart
// the others are at least, along which direction. It is included once for each SIMD target.

#if defined(GRAZE_BVH_FRONT_LEAVES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_FRONT_LEAVES
#undef GRAZE_BVH_FRONT_LEAVES
#else
#define GRAZE_BVH_FRONT_LEAVES
#endif

#include <graze/bvh/wide/front/front_due-inl.h>
#include <graze/bvh/wide/front/local_leaves-inl.h>
#include <graze/bvh/wide/front/plane_store-inl.h>
#include <graze/bvh/wide/lanes/leaf_crossings-inl.h>

#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// A gap along any vector, for each unit of its 1-norm, may be off by so many errors of differences
/// of corners, and by so much of their extent.
inline constexpr float kAlongError = 5;
inline constexpr float kAlongRounding = 0x1p-20f;

/// The gaps between some pairs of primitives of two leaves, off by `error`.
template <typename AnyTag>
class PrimitiveGaps {
 public:
  using Values = hn::Vec<AnyTag>;

  HWY_INLINE PrimitiveGaps(const LocalPairs<AnyTag>& pairs, float error)
      : pairs_(pairs), error_(error) {
    const AnyTag tag;
    const auto zero = hn::Zero(tag);
    Values apart[3];
    Values square = zero;
    squared_distance_ = zero;
    for (int i = 0; i < 3; ++i) {
      const auto& p = pairs.tested;
      const auto& q = pairs.query;
      const Values tested_low = hn::Min(hn::Min(p[0][i], p[1][i]), zero);
      const Values tested_high = hn::Max(hn::Max(p[0][i], p[1][i]), zero);
      const Values low = hn::Add(hn::Min(hn::Min(q[0][i], q[1][i]), zero), pairs.offset[i]);
      const Values high = hn::Add(hn::Max(hn::Max(q[0][i], q[1][i]), zero), pairs.offset[i]);
      const Values above = hn::Sub(low, tested_high);
      const Values below = hn::Sub(tested_low, high);
      const Values gap = known(tag, hn::Sub(hn::Max(above, below), hn::Set(tag, 4 * error)));
      apart[i] = hn::IfThenElse(hn::Gt(below, above), hn::Neg(gap), gap);
      square = hn::MulAdd(gap, gap, square);
      const Values farthest = hn::Sub(hn::Max(high, tested_high), hn::Min(low, tested_low));
      squared_distance_ = hn::MulAdd(farthest, farthest, squared_distance_);
    }
    best_.consider_sum(square, apart);
  }

  /// Looks along the planes and cross products that tell primitives apart.
  HWY_INLINE void look_at(const LeafCrossings<AnyTag>& crossings) {
    const AnyTag tag;
    consider(crossings.is_query_beyond, crossings.query_sides.beyond, crossings.normals.tested,
             crossings.query_sides.is_negative[0]);
    // A tested primitive that is above a query primitive has that below it.
    consider(crossings.is_tested_beyond, crossings.tested_sides.beyond, crossings.normals.query,
             hn::Not(crossings.tested_sides.is_negative[0]));
    const Values margin = crossings.errors.of_sides();
    for (int k = 0; k < 2; ++k) {
      consider(crossings.is_cut, hn::Sub(crossings.cuts.gap[k], margin), crossings.cuts.across[k],
               hn::Lt(crossings.cuts.height[k], hn::Zero(tag)));
    }
  }

  /// Looks along cross products of all edges: what straddles a plane may touch it, and is not known
  /// to.
  HWY_INLINE void look_across() {
    const AnyTag tag;
    // With L the extent and delta the error: corners of the tested node are off by delta, of the
    // query box by 2 delta + u L in each coordinate, places along any vector n, as computed, round
    // by 3.1 u L |n|_1, and a difference of two of these, which rounds as well, is off by |n|_1 (3
    // delta + 11 u L).
    const auto bound = hn::MulAdd(root_above(tag, squared_distance_), hn::Set(tag, kAlongRounding),
                                  hn::Set(tag, kAlongError * error_));
    Values tested[3][3], query[3][3];
    for (int i = 0; i < 3; ++i) {
      tested[0][i] = hn::Zero(tag);
      query[0][i] = pairs_.offset[i];
      for (int c = 1; c < 3; ++c) {
        tested[c][i] = pairs_.tested[c - 1][i];
        query[c][i] = hn::Add(pairs_.offset[i], pairs_.query[c - 1][i]);
      }
    }
    for (int h = 0; h < 3; ++h) {
      for (int g = 0; g < 3; ++g) {
        Values e[3], f[3], normal[3];
        for (int i = 0; i < 3; ++i) {
          e[i] = hn::Sub(tested[(h + 1) % 3][i], tested[h][i]);
          f[i] = hn::Sub(query[(g + 1) % 3][i], query[g][i]);
        }
        set_cross(tag, e, f, normal);
        consider_between(tested, query, normal, bound);
      }
    }
  }

  /// Returns the lanes in which a gap was found.
  HWY_INLINE hn::Mask<AnyTag> are_apart() const { return best_.is_any(); }

  HWY_INLINE void look_along(const float (&direction)[3]) {
    const AnyTag tag;
    const auto along = [&](const Values(&p)[3]) HWY_ATTR {
      return hn::MulAdd(
          p[0], hn::Set(tag, direction[0]),
          hn::MulAdd(p[1], hn::Set(tag, direction[1]), hn::Mul(p[2], hn::Set(tag, direction[2]))));
    };
    const auto zero = hn::Zero(tag);
    const Values end = hn::Max(hn::Max(along(pairs_.tested[0]), along(pairs_.tested[1])), zero);
    const Values start =
        hn::Add(hn::Min(hn::Min(along(pairs_.query[0]), along(pairs_.query[1])), zero),
                along(pairs_.offset));
    // Along a unit vector an error in each of three coordinates counts 1.74 times, that of the
    // products once more.
    const Values gap = hn::Sub(hn::Sub(start, end), hn::Set(tag, 8 * error_));
    const Values normal[3] = {hn::Set(tag, direction[0]), hn::Set(tag, direction[1]),
                              hn::Set(tag, direction[2])};
    best_.consider(known(tag, gap), hn::Set(tag, 1.0f), normal);
  }

  /// Stores what was found from `lane` on, as BoxGaps does.
  template <FrontKind kind>
  HWY_INLINE void store(FrontPlanes<kLeafPairs, kind>& planes, FoundPlanes<kLeafPairs>& found,
                        std::size_t lane, float unit_of_tested) const {
    Values normal[3];
    const Values gap = PlaneStore<kind>::best_of(best_, normal);
    PlaneStore<kind>::write(AnyTag(), planes, found, lane, gap, normal, squared_distance_,
                            unit_of_tested);
  }

 private:
  /// Considers which of the triangles is beyond the other along this vector, or against it.
  HWY_INLINE void consider_between(const Values (&tested)[3][3], const Values (&query)[3][3],
                                   const Values (&n)[3], Values bound) {
    const AnyTag tag;
    Values low[2], high[2];
    set_range(n, tested, low[0], high[0]);
    set_range(n, query, low[1], high[1]);
    const Values above = hn::Sub(low[1], high[0]);
    const Values below = hn::Sub(low[0], high[1]);
    const Values gap = hn::Sub(hn::NegMulAdd(one_norm(tag, n), bound, hn::Max(above, below)),
                               hn::Set(tag, kWideUnderflow));
    consider(hn::Gt(gap, hn::Zero(tag)), gap, n, hn::Gt(below, above));
  }

  HWY_INLINE static void set_range(const Values (&n)[3], const Values (&corners)[3][3], Values& low,
                                   Values& high) {
    const AnyTag tag;
    const Values a = dot(tag, n, corners[0]);
    const Values b = dot(tag, n, corners[1]);
    const Values c = dot(tag, n, corners[2]);
    low = hn::Min(hn::Min(a, b), c);
    high = hn::Max(hn::Max(a, b), c);
  }

  HWY_INLINE void consider(hn::Mask<AnyTag> is_any, Values gap, const Values (&n)[3],
                           hn::Mask<AnyTag> is_back) {
    const AnyTag tag;
    const auto turned = [&](Values v) HWY_ATTR { return hn::IfThenElse(is_back, hn::Neg(v), v); };
    const Values normal[3] = {turned(n[0]), turned(n[1]), turned(n[2])};
    best_.consider_along(hn::IfThenElseZero(is_any, known(tag, gap)), normal);
  }

  const LocalPairs<AnyTag>& pairs_;
  Values squared_distance_;
  float error_;
  BestGap<AnyTag> best_;
};

/// The part of a pass that deals with the leaves of a front: it finds which of their primitives
/// meet, or are near, and planes that keep the others apart.
template <FrontKind kind>
class FrontLeaves : protected FrontDue<kind> {
 protected:
  using Base = FrontDue<kind>;
  using Base::budget_after;
  using Base::outlook_;
  using Base::pass_;
  using Base::planes_;
  using Base::prefetch;
  using Base::renew_budgets;
  using Base::required_;
  using Base::state_;
  using typename Base::LeafPlanes;
  using typename Base::Outlook;

  FrontLeaves(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task)
      : Base(state, pass, task), leaves_(*state.tree[0], *state.tree[1]) {}

  /// Compares leaves that are due: it finds which of their primitives may be within the limit.
  HWY_INLINE void compare_due_leaves() {
    const std::size_t near = renew_budgets(planes_.of_leaves, state_.leaves_budgets);
    state_.looked_at += near;
    for (std::size_t i = 0; i < near; ++i)
      compare_leaves(state_.due[i]);
  }

  /// Decides which primitives of leaves that are busy or due meet. It cannot be predicted in which
  /// leaves some do, so that no branch depends on it.
  HWY_INLINE void decide_leaves() {
    state_.crossing.size = 0;
    state_.unsure.size = 0;
    separate_leaves(decide_busy());
    const std::size_t near = renew_budgets(planes_.of_leaves, state_.leaves_budgets);
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
    std::size_t idle = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (i + 2 * kAhead < size) prefetch(state_.leaves[state_.busy[i + 2 * kAhead]]);
      if (i + kAhead < size) prefetch_leaves(state_.busy[i + kAhead]);
      const std::uint32_t index = state_.busy[i];
      const std::uint32_t asked = set_leaves(state_.leaves[index]);
      state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
      const PairTag tag;
      Meetings found;
      for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
        const LocalPairs<PairTag> pairs(leaves_, first);
        found.add(LeafCrossings<PairTag>(pairs, leaves_.errors().of_pairs(tag)), first);
      }
      const std::uint32_t not_apart = list(index, asked, found);
      state_.busy[busy] = index;
      state_.due[idle] = index;
      busy += not_apart != 0;
      idle += not_apart == 0;
    }
    state_.busy.resize(busy);
    return idle;
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
        prefetch(state_.leaves[state_.due[i + 2 * kAhead]]);
        prefetch(planes_.of_leaves[state_.due[i + 2 * kAhead]]);
      }
      if (i + kAhead < count) prefetch_leaves(state_.due[i + kAhead]);
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
        const auto is_undecided = hn::Not(hn::Or(found.are_apart(), crossings.do_cross));
        if ((bits_of(tag, is_undecided) & asked >> first) != 0) found.look_across();
        found.store(planes, gaps, first, pass_.units[leaves.tested_side]);
      }
      const typename Outlook::Nearness found =
          outlook_[leaves.tested_side].keep(planes, gaps, asked, required_.limit);
      // Primitives that planes keep apart do not meet, be they unsure or not.
      list(index, found.near, met);
      const std::uint32_t is_busy = found.near != 0;
      state_.leaves_budgets[index] = chosen(is_busy, kNever, budget_after(found.motion_left));
      state_.busy[busy] = index;
      busy += is_busy;
    }
    state_.busy.resize(busy);
  }

 private:
  /// Fetches two leaves: those of large meshes are not in the cache.
  HWY_INLINE void prefetch_leaves(std::size_t index) const {
    const WideFront::Leaves& leaves = state_.leaves[index];
    prefetch_leaf(leaves.tested_side, leaves.tested);
    prefetch_leaf(1 - leaves.tested_side, leaves.query);
  }

  HWY_INLINE void prefetch_leaf(int side, const WideFront::Leaf& leaf) const {
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

  /// The pairs of two leaves that surely cross, and those that are surely apart, as bits.
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
    const std::uint32_t not_apart = asked & ~found.apart;
    add_lanes(state_.crossing, index, not_apart & found.crossing);
    if ((not_apart & ~found.crossing) != 0)
      add_lanes(state_.unsure, index, not_apart & ~found.crossing);
    return not_apart;
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
        outlook_[leaves.tested_side].keep(planes, gaps, asked, required_.limit);
    state_.leaves_budgets[index] = budget_after(found.motion_left);
    leaves.listed |= found.near;
    for (std::uint32_t near = found.near; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      state_.near_pairs.push_back(static_cast<std::uint32_t>(kLeafPairs * index) + lane);
    }
    state_.near_pair_budgets.resize(state_.near_pairs.size(), kDueNow);
    state_.near_pair_planes.resize(state_.near_pairs.size());
  }

  LocalLeaves leaves_;
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
