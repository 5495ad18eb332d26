// How far B goes until it meets A, of boxes and of primitives along the axes of a cast. Included
// once for each SIMD target.

#if defined(GRAZE_BVH_CAST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_CAST_LANES
#undef GRAZE_BVH_CAST_LANES
#else
#define GRAZE_BVH_CAST_LANES
#endif

#include <graze/bvh/wide/lanes/pair_lanes-inl.h>
#include <graze/bvh/wide/walk/aligned_node-inl.h>
#include <graze/bvh/wide/walk/wide_cast_walk.h>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

using AlongNode = WideCastWalk::Along<AlignedNode>;
using AlongLeaf = WideCastWalk::Along<AlignedLeaf>;

// Intervals hold what they are of; a difference of two rounds, a product with what stands along the
// normal, and one with this.
inline constexpr float kBoundShare = 1 - 0x1p-20f;

/// Where things of A and B begin and end along one axis.
template <typename AnyTag>
struct CastInterval {
  hn::Vec<AnyTag> low_a, high_a, low_b, high_b;
};

/// What some axes say of as many pairs as there are lanes.
template <typename AnyTag>
class CastBound {
 public:
  using Values = hn::Vec<AnyTag>;

  HWY_INLINE CastBound() : never_(hn::FirstN(AnyTag(), 0)), bound_(hn::Zero(AnyTag())) {}

  /// Across the direction nothing changes: what is beside each other never meets.
  HWY_INLINE void look_across(const CastInterval<AnyTag>& at) {
    never_ = hn::Or(never_, hn::Or(hn::Gt(at.low_a, at.high_b), hn::Gt(at.low_b, at.high_a)));
  }

  /// B goes up along this axis, and by so much as `factor` says along the direction: what begins
  /// above has been passed, what ends below is met later.
  HWY_INLINE void look_along(const CastInterval<AnyTag>& at, float factor) {
    never_ = hn::Or(never_, hn::Gt(at.low_b, at.high_a));
    const Values lower = hn::Mul(hn::Sub(at.low_a, at.high_b), hn::Set(AnyTag(), factor));
    bound_ = hn::IfThenElse(hn::Gt(lower, bound_), lower, bound_);  // not if it is not a number
  }

  HWY_INLINE Values bound() const { return hn::Mul(bound_, hn::Set(AnyTag(), kBoundShare)); }

  /// The bits of the lanes that may meet before the limit.
  HWY_INLINE std::uint32_t may_meet(Values bound, float limit) const {
    const AnyTag tag;
    return bits_of(tag, hn::Not(hn::Or(never_, hn::Gt(bound, hn::Set(tag, limit)))));
  }

 private:
  hn::Mask<AnyTag> never_;
  Values bound_;
};

/// A query box along all axes.
struct CastBox {
  float low[2][3];  ///< straight, and turned
  float high[2][3];
};

HWY_INLINE void set_cast_box(CastBox& box, const AlongNode& boxes, std::uint32_t lane) {
  for (int k = 0; k < 3; ++k) {
    box.low[0][k] = boxes.straight.low[k][lane];
    box.high[0][k] = boxes.straight.high[k][lane];
    box.low[1][k] = boxes.turned.low[k][lane];
    box.high[1][k] = boxes.turned.high[k][lane];
  }
}

/// Which children of a tested node may meet a query box before the limit, and their bounds.
HWY_INLINE std::uint32_t set_cast_bounds(float (&bounds)[WideNode::kWidth], const AlongNode& tested,
                                         const CastBox& query, int tested_side, float per_normal,
                                         float limit) {
  const Tag tag;
  const AlignedNode* const frames[2] = {&tested.straight, &tested.turned};
  std::uint32_t near = 0;
  for (std::size_t part = 0; part < WideNode::kWidth; part += hn::Lanes(tag)) {
    const auto at = [&](int frame, int axis) HWY_ATTR -> CastInterval<Tag> {
      const Lanes low_t = hn::Load(tag, frames[frame]->low[axis] + part);
      const Lanes high_t = hn::Load(tag, frames[frame]->high[axis] + part);
      const Lanes low_q = hn::Set(tag, query.low[frame][axis]);
      const Lanes high_q = hn::Set(tag, query.high[frame][axis]);
      if (tested_side == 0) return {low_t, high_t, low_q, high_q};
      return {low_q, high_q, low_t, high_t};
    };
    CastBound<Tag> found;
    for (int axis = 1; axis < 3; ++axis) {
      found.look_across(at(0, axis));
      found.look_across(at(1, axis));
    }
    found.look_along(at(0, 0), 1);
    found.look_along(at(1, 0), per_normal);
    const Lanes bound = found.bound();
    hn::Store(bound, tag, bounds + part);
    near |= found.may_meet(bound, limit) << part;
  }
  return near;
}

/// The primitives of a leaf along each axis.
inline HWY_NOINLINE void set_aligned_leaf(AlignedLeaf& leaf, const WideTree::Treelet& treelet,
                                          std::uint32_t link, const AlignedTransform& transform) {
  const FourTag tag;
  const std::uint32_t count = ChildLink::count(link);
  const float* rows = rows_of(treelet, link);
  const Four infinity = hn::Set(tag, std::numeric_limits<float>::infinity());
  for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
    Four p[3][3];
    for (std::uint32_t c = 0; c < 3; ++c) {
      for (std::uint32_t i = 0; i < 3; ++i)
        p[c][i] = hn::LoadU(tag, rows + (3 * c + i) * count + part);
    }
    for (int k = 0; k < 3; ++k) {
      const auto origin = static_cast<float>(aligned_at(transform, k, treelet.origin));
      const Four margin = hn::Set(
          tag, kAlignedError * (std::abs(origin) + treelet.largest_coordinate * transform.unit) +
                   transform.slack);
      Four at[3];
      for (std::uint32_t c = 0; c < 3; ++c) {
        const auto row = [&](int i) HWY_ATTR { return hn::Set(tag, transform.rows[k][i]); };
        at[c] = hn::MulAdd(p[c][0], row(0), hn::MulAdd(p[c][1], row(1), hn::Mul(p[c][2], row(2))));
      }
      const Four least = hn::Min(at[0], hn::Min(at[1], at[2]));
      const Four most = hn::Max(at[0], hn::Max(at[1], at[2]));
      const Four low = hn::Sub(hn::Add(least, hn::Set(tag, origin)), margin);
      const Four high = hn::Add(hn::Add(most, hn::Set(tag, origin)), margin);
      // What overflowed may be anywhere.
      const auto is_known = hn::Le(low, high);
      hn::Store(hn::IfThenElse(is_known, low, hn::Neg(infinity)), tag, leaf.low[k] + part);
      hn::Store(hn::IfThenElse(is_known, high, infinity), tag, leaf.high[k] + part);
    }
  }
}

/// The box of a leaf of so many primitives: as tight as they are.
HWY_INLINE void set_cast_box(CastBox& box, const AlongLeaf& leaf, std::uint32_t count) {
  const FourTag tag;
  const AlignedLeaf* const frames[2] = {&leaf.straight, &leaf.turned};
  const Four infinity = hn::Set(tag, std::numeric_limits<float>::infinity());
  for (int frame = 0; frame < 2; ++frame) {
    for (int k = 0; k < 3; ++k) {
      Four least = infinity, most = hn::Neg(infinity);
      for (std::uint32_t part = 0; part < count;
           part += static_cast<std::uint32_t>(hn::Lanes(tag))) {
        const auto is_there = hn::FirstN(tag, count - part);
        least = hn::Min(
            least, hn::IfThenElse(is_there, hn::Load(tag, frames[frame]->low[k] + part), infinity));
        most = hn::Max(most, hn::IfThenElse(is_there, hn::Load(tag, frames[frame]->high[k] + part),
                                            hn::Neg(infinity)));
      }
      box.low[frame][k] = hn::GetLane(hn::MinOfLanes(tag, least));
      box.high[frame][k] = hn::GetLane(hn::MaxOfLanes(tag, most));
    }
  }
}

/// Which pairs of primitives of two leaves may meet before the limit, and their bounds.
inline HWY_NOINLINE std::uint32_t set_cast_bounds(float (&bounds)[kLeafPairs], const AlongLeaf& a,
                                                  const AlongLeaf& b, float per_normal,
                                                  float limit) {
  const PairTag tag;
  std::uint32_t near = 0;
  for (std::size_t part = 0; part < kLeafPairs; part += hn::Lanes(tag)) {
    const PairLanes<PairTag> lanes(part);
    const auto at = [&](const AlignedLeaf& of_a, const AlignedLeaf& of_b, int axis)
                        HWY_ATTR -> CastInterval<PairTag> {
      return {lanes.tested(of_a.low[axis]), lanes.tested(of_a.high[axis]),
              lanes.query(of_b.low[axis]), lanes.query(of_b.high[axis])};
    };
    CastBound<PairTag> found;
    for (int axis = 1; axis < 3; ++axis) {
      found.look_across(at(a.straight, b.straight, axis));
      found.look_across(at(a.turned, b.turned, axis));
    }
    found.look_along(at(a.straight, b.straight, 0), 1);
    found.look_along(at(a.turned, b.turned, 0), per_normal);
    const auto bound = found.bound();
    hn::Store(bound, tag, bounds + part);
    near |= found.may_meet(bound, limit) << part;
  }
  return near;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
