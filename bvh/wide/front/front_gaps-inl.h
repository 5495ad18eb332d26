// How far apart boxes, and primitives of leaves, of two wide trees are at least, and along which
// direction. Included once for each SIMD target.

#if defined(GRAZE_BVH_FRONT_GAPS) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_FRONT_GAPS
#undef GRAZE_BVH_FRONT_GAPS
#else
#define GRAZE_BVH_FRONT_GAPS
#endif

#include <graze/bvh/wide/front/front_planes.h>
#include <graze/bvh/wide/front/leaf_crossings-inl.h>
#include <graze/bvh/wide/front/wide_front.h>
#include <graze/bvh/wide/lanes/query_gaps-inl.h>
#include <graze/bvh/wide/lanes/slab_lanes-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Pays for kBoundGrowth, roots and products.
inline constexpr float kShrink = 1 - 0x1p-13f;

/// What is further counts as so far.
inline constexpr float kFarthest = 0x1p60f;

/// Of how far apart things are, what a direction costs that is rounded after the gap along it was
/// found: 15 u for the directions of boxes, with the turn to the tree's axes; u = 2^-24.
inline constexpr float kDirectionError = 0x1p-19f;

/// Of gaps along any vector, for each unit of its 1-norm: how many errors of differences of
/// corners, and of their extent.
inline constexpr float kAlongError = 5;
inline constexpr float kAlongRounding = 0x1p-20f;

/// What estimates of reciprocals and of reciprocal roots are off by at most, on any target.
inline constexpr float kEstimateError = 0x1p-7f;

template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> padded_square(AnyTag tag, const hn::Vec<AnyTag> (&v)[3]) {
  // A vector that vanishes is shorter than what is added.
  const auto padding = hn::Set(tag, kWideUnderflow);
  return hn::MulAdd(v[0], v[0], hn::MulAdd(v[1], v[1], hn::MulAdd(v[2], v[2], padding)));
}

/// No less than the root.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> root_above(AnyTag tag, hn::Vec<AnyTag> square) {
  const auto padded = hn::Add(square, hn::Set(tag, kWideUnderflow));
  return hn::Mul(hn::Mul(padded, hn::ApproximateReciprocalSqrt(padded)),
                 hn::Set(tag, 1 + 2 * kEstimateError));
}

/// A gap along a direction that was rounded: less than any motion makes up for where distances are
/// as large as gaps may be, or overflow.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> if_near(AnyTag tag, hn::Vec<AnyTag> gap,
                                   hn::Vec<AnyTag> squared_distance) {
  const auto farthest = hn::Set(tag, kFarthest * kFarthest);
  return hn::IfThenElse(hn::Lt(squared_distance, farthest), gap, hn::Neg(farthest));
}

/// The largest gap found so far, and the direction along which it is.
template <typename AnyTag>
class BestGap {
 public:
  using Values = hn::Vec<AnyTag>;

  HWY_INLINE BestGap() : gap_(hn::Zero(AnyTag())), per_length_(gap_), normal_{gap_, gap_, gap_} {}

  /// Along a vector whose length may be anything.
  HWY_INLINE void offer_along(Values gap, const Values (&n)[3]) {
    const auto per_length = hn::ApproximateReciprocalSqrt(padded_square(AnyTag(), n));
    offer(hn::Mul(gap, per_length), per_length, n);
  }

  /// Gaps along three directions at right angles, as lengths of steps, make a gap along their sum.
  HWY_INLINE void offer_sum(Values square, const Values (&step)[3]) {
    const auto padded = hn::Add(square, hn::Set(AnyTag(), kWideUnderflow));
    const auto per_length = hn::ApproximateReciprocalSqrt(padded);
    offer(hn::Mul(square, per_length), per_length, step);
  }

  /// Along a vector of a length times `per_length` of 1, or less.
  HWY_INLINE void offer(Values gap, Values per_length, const Values (&n)[3]) {
    const auto is_better = hn::Gt(gap, gap_);
    gap_ = hn::IfThenElse(is_better, gap, gap_);
    per_length_ = hn::IfThenElse(is_better, per_length, per_length_);
    for (int i = 0; i < 3; ++i)
      normal_[i] = hn::IfThenElse(is_better, n[i], normal_[i]);
  }

  /// Whether anything was found.
  HWY_INLINE hn::Mask<AnyTag> is_any() const { return hn::Gt(gap_, hn::Zero(AnyTag())); }

  /// The vector made as long as 1, and the gap along it.
  HWY_INLINE Values normalized(Values (&normal)[3]) const {
    const AnyTag tag;
    const auto per_length = hn::Div(hn::Set(tag, 1.0f), hn::Sqrt(padded_square(tag, normal_)));
    for (int i = 0; i < 3; ++i)
      normal[i] = hn::Mul(normal_[i], per_length);
    const auto gap = hn::Mul(gap_, hn::Div(per_length, per_length_));
    return hn::Min(known(tag, gap), hn::Set(tag, kFarthest));
  }

  /// The same with less precision, in less time: no longer than 1, however its length was
  /// estimated.
  HWY_INLINE Values shortened(Values (&normal)[3]) const {
    const AnyTag tag;
    const auto shorter = hn::Set(tag, 1 - kEstimateError);
    const auto per_length = hn::Mul(per_length_, shorter);
    for (int i = 0; i < 3; ++i)
      normal[i] = hn::Mul(normal_[i], per_length);
    return hn::Min(known(tag, hn::Mul(gap_, shorter)), hn::Set(tag, kFarthest));
  }

 private:
  Values gap_;
  Values per_length_;
  Values normal_[3];
};

/// What a front keeps of gaps where it is to tell whether anything meets.
template <FrontBounds bounds>
struct PlaneStore;

template <>
struct PlaneStore<FrontBounds::Meeting> {
  template <std::size_t lanes>
  using Planes = FrontPlanes<lanes, FrontBounds::Meeting>;

  /// Normals in parts, and gaps.
  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static hn::Vec<AnyTag> read(AnyTag tag, const Planes<lanes>& planes, std::size_t lane,
                                         hn::Vec<AnyTag> (&normal)[3]) {
    const hn::Rebind<std::int16_t, AnyTag> halves;
    const hn::RebindToSigned<AnyTag> whole;
    for (int i = 0; i < 3; ++i) {
      const auto parts = hn::LoadU(halves, planes.normal[i] + lane);
      normal[i] = hn::ConvertTo(tag, hn::PromoteTo(whole, parts));
    }
    return hn::Load(tag, planes.gap + lane);
  }

  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static void write_gaps(AnyTag tag, Planes<lanes>& planes, std::size_t lane,
                                    hn::Vec<AnyTag> gaps) {
    hn::Store(gaps, tag, planes.gap + lane);
  }

  /// From `lane` on: the best that was found, and gaps along that. Points of both are no further
  /// apart than the root of this square, in the units of the tested node, as gaps are.
  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static void write(AnyTag tag, Planes<lanes>& planes, FoundPlanes<lanes>& found,
                               std::size_t lane, hn::Vec<AnyTag> gap,
                               const hn::Vec<AnyTag> (&normal)[3], hn::Vec<AnyTag> squared_distance,
                               float unit_of_tested) {
    const hn::Rebind<std::int16_t, AnyTag> halves;
    const auto shorter = hn::Set(tag, Planes<lanes>::kParts * Planes<lanes>::kPart);
    // Rounding to parts changes a normal by kLongest at most; what it is off by comes on top.
    constexpr float kLongest = 0.87f * Planes<lanes>::kPart;
    auto off = hn::Set(tag, kDirectionError * (kDirectionError + 2 * kLongest));
    for (int i = 0; i < 3; ++i) {
      const auto rounded = hn::NearestInt(hn::Mul(normal[i], hn::Set(tag, Planes<lanes>::kParts)));
      hn::StoreU(hn::DemoteTo(halves, rounded), halves, planes.normal[i] + lane);
      const auto stored = hn::ConvertTo(tag, rounded);
      hn::Store(stored, tag, found.normal[i] + lane);
      const auto change =
          hn::MulSub(stored, hn::Set(tag, Planes<lanes>::kPart), hn::Mul(normal[i], shorter));
      off = hn::MulAdd(change, change, off);
    }
    const auto unit = hn::Set(tag, unit_of_tested * kShrink);
    hn::Store(hn::Mul(gap, unit), tag, found.gap + lane);
    const auto loss = root_above(tag, hn::Mul(off, squared_distance));
    const auto stored_gap = hn::Mul(hn::MulSub(gap, shorter, loss), unit);
    hn::Store(if_near(tag, stored_gap, squared_distance), tag, found.stored_gap + lane);
  }

  template <typename AnyTag>
  HWY_INLINE static hn::Vec<AnyTag> best_of(const BestGap<AnyTag>& best,
                                            hn::Vec<AnyTag> (&normal)[3]) {
    return best.shortened(normal);
  }
};

/// Where it is to tell how far things are apart.
template <>
struct PlaneStore<FrontBounds::Distance> {
  template <std::size_t lanes>
  using Planes = FrontPlanes<lanes, FrontBounds::Distance>;

  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static hn::Vec<AnyTag> read(AnyTag tag, const Planes<lanes>& planes, std::size_t lane,
                                         hn::Vec<AnyTag> (&normal)[3]) {
    for (int i = 0; i < 3; ++i)
      normal[i] = hn::Load(tag, planes.normal[i] + lane);
    return hn::Load(tag, planes.gap + lane);
  }

  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static void write_gaps(AnyTag tag, Planes<lanes>& planes, std::size_t lane,
                                    hn::Vec<AnyTag> gaps) {
    hn::Store(gaps, tag, planes.gap + lane);
  }

  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static void write(AnyTag tag, Planes<lanes>& planes, FoundPlanes<lanes>& found,
                               std::size_t lane, hn::Vec<AnyTag> gap,
                               const hn::Vec<AnyTag> (&normal)[3], hn::Vec<AnyTag> squared_distance,
                               float unit_of_tested) {
    for (int i = 0; i < 3; ++i) {
      hn::Store(normal[i], tag, planes.normal[i] + lane);
      hn::Store(normal[i], tag, found.normal[i] + lane);
    }
    const auto unit = hn::Set(tag, unit_of_tested * kShrink);
    const auto loss = hn::Mul(root_above(tag, squared_distance), hn::Set(tag, kDirectionError));
    hn::Store(hn::Mul(gap, unit), tag, found.gap + lane);
    const auto stored_gap = hn::Mul(hn::Sub(gap, loss), unit);
    hn::Store(if_near(tag, stored_gap, squared_distance), tag, found.stored_gap + lane);
  }

  template <typename AnyTag>
  HWY_INLINE static hn::Vec<AnyTag> best_of(const BestGap<AnyTag>& best,
                                            hn::Vec<AnyTag> (&normal)[3]) {
    return best.normalized(normal);
  }
};

/// Some children of a tested node beside a query box, along the axes of the tested node.
class BoxGaps {
 public:
  HWY_INLINE BoxGaps(const WideNode& tested, const QueryInNode& query, std::size_t lane)
      : tested_(tested), query_(query) {
    const Tag tag;
    Lanes step[3], turned[3];
    Lanes square = hn::Zero(tag);
    squared_distance_ = square;
    for (int i = 0; i < 3; ++i) {
      half_[i] = hn::Load(tag, tested.half[i] + lane);
      offset_[i] = hn::Sub(hn::Set(tag, query.offset[i]), hn::Load(tag, tested.centre[i] + lane));
      const Lanes size = hn::Abs(offset_[i]);
      const Lanes gap = known(tag, hn::Sub(size, hn::Add(half_[i], hn::Set(tag, query.radius[i]))));
      step[i] = hn::CopySign(gap, offset_[i]);
      square = hn::MulAdd(gap, gap, square);
      const Lanes farthest = hn::Add(size, hn::Add(half_[i], hn::Set(tag, query.radius[i])));
      squared_distance_ = hn::MulAdd(farthest, farthest, squared_distance_);
      turned[i] = hn::Zero(tag);
    }
    best_.offer_sum(square, step);
    square = hn::Zero(tag);
    for (int k = 0; k < 3; ++k) {
      const Lanes distance =
          hn::MulAdd(offset_[0], axis(k, 0),
                     hn::MulAdd(offset_[1], axis(k, 1), hn::Mul(offset_[2], axis(k, 2))));
      const Lanes radii =
          hn::MulAdd(half_[0], size(k, 0),
                     hn::MulAdd(half_[1], size(k, 1),
                                hn::MulAdd(half_[2], size(k, 2), hn::Set(tag, query.half[k]))));
      const Lanes gap = known(tag, hn::Sub(hn::Abs(distance), radii));
      const Lanes along = hn::CopySign(gap, distance);
      square = hn::MulAdd(gap, gap, square);
      for (int i = 0; i < 3; ++i)
        turned[i] = hn::MulAdd(along, axis(k, i), turned[i]);
    }
    best_.offer_sum(square, turned);
  }

  /// Along cross products of axes, which are no longer than 1.
  HWY_INLINE void look_across() {
    const Tag tag;
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        const Lanes distance =
            hn::MulSub(offset_[i2], axis(k, i1), hn::Mul(offset_[i1], axis(k, i2)));
        const Lanes radii =
            hn::MulAdd(half_[i1], size(k, i2),
                       hn::MulAdd(half_[i2], size(k, i1), hn::Set(tag, query_.cross_radius[k][i])));
        const Lanes gap = hn::Sub(hn::Abs(distance), radii);
        const auto is_back = hn::Lt(distance, hn::Zero(tag));
        Lanes normal[3];
        normal[i] = hn::Zero(tag);
        normal[i1] = hn::IfThenElse(is_back, axis(k, i2), hn::Neg(axis(k, i2)));
        normal[i2] = hn::IfThenElse(is_back, hn::Neg(axis(k, i1)), axis(k, i1));
        best_.offer(known(tag, gap), hn::Set(tag, 1.0f), normal);
      }
    }
  }

  /// Along the normals of the slabs of the tested node's children, of which nothing else is known:
  /// where boxes overlap along all their axes no offset of middles is longer than both boxes.
  HWY_INLINE void look_along_slabs(std::size_t lane, const QuerySlab& slab) {
    const Tag tag;
    const SlabLanes slabs(tested_, lane, half_);
    const SlabGap found(slabs, offset_, OneQuery{query_}, slab);
    const Lanes sign = hn::CopySign(hn::Set(tag, 1.0f), found.distance);
    const Lanes normal[3] = {hn::Mul(sign, slabs.slope[0]), hn::Mul(sign, slabs.slope[1]), sign};
    const Lanes gap = known(tag, hn::Sub(hn::Abs(found.distance), found.radii));
    best_.offer_along(hn::IfThenZeroElse(are_apart(), gap), normal);
  }

  HWY_INLINE hn::Mask<Tag> are_apart() const { return best_.is_any(); }

  HWY_INLINE void look_along(const Aim& aim) {
    const Tag tag;
    Lanes along = hn::Zero(tag);
    Lanes radii = hn::Set(tag, aim.radius);
    for (int i = 0; i < 3; ++i) {
      along = hn::MulAdd(offset_[i], hn::Set(tag, aim.axes[i]), along);
      radii = hn::MulAdd(half_[i], hn::Set(tag, aim.size[i]), radii);
    }
    const Lanes gap = known(tag, hn::Sub(along, radii));
    const Lanes axes[3] = {hn::Set(tag, aim.axes[0]), hn::Set(tag, aim.axes[1]),
                           hn::Set(tag, aim.axes[2])};
    best_.offer(gap, hn::Set(tag, 1.0f), axes);
  }

  /// What was found, in the frame of the tested node's tree, in common units.
  template <FrontBounds bounds>
  HWY_INLINE void store(FrontPlanes<WideNode::kWidth, bounds>& planes,
                        FoundPlanes<WideNode::kWidth>& found, std::size_t lane,
                        float unit_of_tested) const {
    const Tag tag;
    Lanes normal[3];
    Lanes turned[3];
    const Lanes gap = PlaneStore<bounds>::best_of(best_, normal);
    for (int i = 0; i < 3; ++i) {
      turned[i] = hn::MulAdd(normal[0], hn::Set(tag, tested_.axes[i][0]),
                             hn::MulAdd(normal[1], hn::Set(tag, tested_.axes[i][1]),
                                        hn::Mul(normal[2], hn::Set(tag, tested_.axes[i][2]))));
    }
    PlaneStore<bounds>::write(tag, planes, found, lane, gap, turned, squared_distance_,
                              unit_of_tested);
  }

 private:
  HWY_INLINE Lanes axis(int k, int i) const { return hn::Set(Tag(), query_.axes[k][i]); }
  HWY_INLINE Lanes size(int k, int i) const { return hn::Set(Tag(), query_.size[k][i]); }

  const WideNode& tested_;
  const QueryInNode& query_;
  Lanes half_[3];
  Lanes offset_[3];
  Lanes squared_distance_;  // than which no points of both are further apart
  BestGap<Tag> best_;
};

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
