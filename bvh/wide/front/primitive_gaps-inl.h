// How far apart the primitives of two leaves are at least, and along which direction. Included once
// for each SIMD target.

#if defined(GRAZE_BVH_PRIMITIVE_GAPS) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_PRIMITIVE_GAPS
#undef GRAZE_BVH_PRIMITIVE_GAPS
#else
#define GRAZE_BVH_PRIMITIVE_GAPS
#endif

#include <graze/bvh/wide/lanes/leaf_crossings-inl.h>
#include <graze/bvh/wide/front/plane_store-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Of gaps along any vector, for each unit of its 1-norm: how many errors of differences of
/// corners, and of their extent.
inline constexpr float kAlongError = 5;
inline constexpr float kAlongRounding = 0x1p-20f;

/// Some pairs of primitives of two leaves, off by `error`.
template <typename AnyTag>
class PrimitiveGaps {
 public:
  using Values = hn::Vec<AnyTag>;

  HWY_INLINE PrimitiveGaps(const LocalPairs<AnyTag>& pairs, float error)
      : pairs_(pairs), error_(error) {
    const AnyTag tag;
    const auto zero = hn::Zero(tag);
    Values step[3];
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
      step[i] = hn::IfThenElse(hn::Gt(below, above), hn::Neg(gap), gap);
      square = hn::MulAdd(gap, gap, square);
      const Values farthest = hn::Sub(hn::Max(high, tested_high), hn::Min(low, tested_low));
      squared_distance_ = hn::MulAdd(farthest, farthest, squared_distance_);
    }
    best_.offer_sum(square, step);
  }

  /// The planes and cross products that tell primitives apart.
  HWY_INLINE void look_at(const LeafCrossings<AnyTag>& crossings) {
    const AnyTag tag;
    offer(crossings.is_query_beyond, crossings.query_sides.beyond, crossings.normals.tested,
          crossings.query_sides.is_negative[0]);
    // What is above a query box has the query box below it.
    offer(crossings.is_tested_beyond, crossings.tested_sides.beyond, crossings.normals.query,
          hn::Not(crossings.tested_sides.is_negative[0]));
    const Values margin = crossings.errors.of_sides();
    for (int k = 0; k < 2; ++k) {
      offer(crossings.is_cut, hn::Sub(crossings.cuts.gap[k], margin), crossings.cuts.across[k],
            hn::Lt(crossings.cuts.height[k], hn::Zero(tag)));
    }
  }

  /// Along cross products of all edges: what straddles a plane may touch it, and is not known to.
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
        offer_between(tested, query, normal, bound);
      }
    }
  }

  /// Whether anything was found.
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
    best_.offer(known(tag, gap), hn::Set(tag, 1.0f), normal);
  }

  /// As in BoxGaps, from `lane` on.
  template <FrontBounds bounds>
  HWY_INLINE void store(FrontPlanes<kLeafPairs, bounds>& planes, FoundPlanes<kLeafPairs>& found,
                        std::size_t lane, float unit_of_tested) const {
    Values normal[3];
    const Values gap = PlaneStore<bounds>::best_of(best_, normal);
    PlaneStore<bounds>::write(AnyTag(), planes, found, lane, gap, normal, squared_distance_,
                              unit_of_tested);
  }

 private:
  /// Which of the triangles is beyond the other along this vector, or against it.
  HWY_INLINE void offer_between(const Values (&tested)[3][3], const Values (&query)[3][3],
                                const Values (&n)[3], Values bound) {
    const AnyTag tag;
    Values low[2], high[2];
    set_range(n, tested, low[0], high[0]);
    set_range(n, query, low[1], high[1]);
    const Values above = hn::Sub(low[1], high[0]);
    const Values below = hn::Sub(low[0], high[1]);
    const Values gap = hn::Sub(hn::NegMulAdd(one_norm(tag, n), bound, hn::Max(above, below)),
                               hn::Set(tag, kWideUnderflow));
    offer(hn::Gt(gap, hn::Zero(tag)), gap, n, hn::Gt(below, above));
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

  HWY_INLINE void offer(hn::Mask<AnyTag> is_any, Values gap, const Values (&n)[3],
                        hn::Mask<AnyTag> is_back) {
    const AnyTag tag;
    const auto turned = [&](Values v) HWY_ATTR { return hn::IfThenElse(is_back, hn::Neg(v), v); };
    const Values normal[3] = {turned(n[0]), turned(n[1]), turned(n[2])};
    best_.offer_along(hn::IfThenElseZero(is_any, known(tag, gap)), normal);
  }

  const LocalPairs<AnyTag>& pairs_;
  Values squared_distance_;
  float error_;
  BestGap<AnyTag> best_;
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
