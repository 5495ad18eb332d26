// This finds, stores and reads the planes of a front: the largest of several gaps, with the
// direction along which it is, and what rounding that direction costs. It is included once for each
// SIMD target.

#if defined(GRAZE_BVH_PLANE_STORE) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_PLANE_STORE
#undef GRAZE_BVH_PLANE_STORE
#else
#define GRAZE_BVH_PLANE_STORE
#endif

#include <graze/bvh/wide/front/front_planes.h>
#include <graze/bvh/wide/front/wide_front.h>
#include <graze/bvh/wide/lanes/query_gaps-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// The largest distance that is told apart: what is further counts as so far.
inline constexpr auto kFarthest = static_cast<float>(WideFront::kFarthest);

/// Estimates of reciprocals and of reciprocal roots are off by at most this, on any target.
inline constexpr float kEstimateError = 0x1p-7f;

template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> padded_square(AnyTag tag, const hn::Vec<AnyTag> (&v)[3]) {
  // A vector that vanishes is shorter than what is added.
  const auto padding = hn::Set(tag, kWideUnderflow);
  return hn::MulAdd(v[0], v[0], hn::MulAdd(v[1], v[1], hn::MulAdd(v[2], v[2], padding)));
}

/// The largest gap found so far, and the direction along which it is.
template <typename AnyTag>
class BestGap {
 public:
  using Values = hn::Vec<AnyTag>;

  HWY_INLINE BestGap() : gap_(hn::Zero(AnyTag())), per_length_(gap_), normal_{gap_, gap_, gap_} {}

  /// Considers a gap along a vector whose length may be anything.
  HWY_INLINE void consider_along(Values gap, const Values (&n)[3]) {
    const auto per_length = hn::ApproximateReciprocalSqrt(padded_square(AnyTag(), n));
    consider(hn::Mul(gap, per_length), per_length, n);
  }

  /// Considers gaps along three directions at right angles: as vectors along these, they make a gap
  /// along their sum.
  HWY_INLINE void consider_sum(Values square, const Values (&sum)[3]) {
    const auto padded = hn::Add(square, hn::Set(AnyTag(), kWideUnderflow));
    const auto per_length = hn::ApproximateReciprocalSqrt(padded);
    consider(hn::Mul(square, per_length), per_length, sum);
  }

  /// Considers a gap along a vector whose length times `per_length` is 1, or less.
  HWY_INLINE void consider(Values gap, Values per_length, const Values (&n)[3]) {
    const auto is_better = hn::Gt(gap, gap_);
    gap_ = hn::IfThenElse(is_better, gap, gap_);
    per_length_ = hn::IfThenElse(is_better, per_length, per_length_);
    for (int i = 0; i < 3; ++i)
      normal_[i] = hn::IfThenElse(is_better, n[i], normal_[i]);
  }

  /// Returns the lanes in which a gap was found.
  HWY_INLINE hn::Mask<AnyTag> is_any() const { return hn::Gt(gap_, hn::Zero(AnyTag())); }

  /// Writes the vector made as long as 1, and returns the gap along it.
  HWY_INLINE Values normalized(Values (&normal)[3]) const {
    const AnyTag tag;
    const auto per_length = hn::Div(hn::Set(tag, 1.0f), hn::Sqrt(padded_square(tag, normal_)));
    for (int i = 0; i < 3; ++i)
      normal[i] = hn::Mul(normal_[i], per_length);
    const auto gap = hn::Mul(gap_, hn::Div(per_length, per_length_));
    return hn::Min(known(tag, gap), hn::Set(tag, kFarthest));
  }

  /// Does the same with less precision, in less time: the vector is no longer than 1, however its
  /// length was estimated.
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

/// Gaps are multiplied by this. It covers kBoundGrowth, and the rounding of roots and products.
inline constexpr float kShrink = 1 - 0x1p-13f;

/// A direction that is rounded after the gap along it was found costs this share of how far apart
/// things are: 15 u for the directions of boxes, with the turn to the tree's axes; u = 2^-24.
inline constexpr float kDirectionError = 0x1p-19f;

/// Returns a value that is no less than the root.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> root_above(AnyTag tag, hn::Vec<AnyTag> square) {
  const auto padded = hn::Add(square, hn::Set(tag, kWideUnderflow));
  return hn::Mul(hn::Mul(padded, hn::ApproximateReciprocalSqrt(padded)),
                 hn::Set(tag, 1 + 2 * kEstimateError));
}

/// Returns a gap along a direction that was rounded, or, where distances are as large as gaps may
/// be or overflow, one so far below 0 that no motion makes up for it.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> if_near(AnyTag tag, hn::Vec<AnyTag> gap,
                                   hn::Vec<AnyTag> squared_distance) {
  const auto farthest = hn::Set(tag, kFarthest * kFarthest);
  return hn::IfThenElse(hn::Lt(squared_distance, farthest), gap, hn::Neg(farthest));
}

/// Stores gaps in common units: along the direction that was found, and along the same as it is
/// stored.
template <typename AnyTag, std::size_t lanes>
HWY_INLINE void store_gaps(AnyTag tag, FoundPlanes<lanes>& found, std::size_t lane,
                           hn::Vec<AnyTag> gap, hn::Vec<AnyTag> along_stored,
                           hn::Vec<AnyTag> squared_distance, float unit_of_tested) {
  const auto unit = hn::Set(tag, unit_of_tested * kShrink);
  hn::Store(hn::Mul(gap, unit), tag, found.gap + lane);
  hn::Store(if_near(tag, hn::Mul(along_stored, unit), squared_distance), tag,
            found.stored_gap + lane);
}

/// Stores and reads the planes of a front that is to tell whether anything meets.
template <FrontKind kind>
struct PlaneStore;

template <>
struct PlaneStore<FrontKind::Intersection> {
  template <std::size_t lanes>
  using Planes = FrontPlanes<lanes, FrontKind::Intersection>;

  /// Reads normals, in units, and returns gaps.
  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static hn::Vec<AnyTag> read(AnyTag tag, const Planes<lanes>& planes, std::size_t lane,
                                         hn::Vec<AnyTag> (&normal)[3]) {
    const hn::Rebind<std::int16_t, AnyTag> halves;
    const hn::RebindToSigned<AnyTag> whole;
    for (int i = 0; i < 3; ++i) {
      const auto units = hn::LoadU(halves, planes.normal[i] + lane);
      normal[i] = hn::ConvertTo(tag, hn::PromoteTo(whole, units));
    }
    return hn::Load(tag, planes.gap + lane);
  }

  /// Writes from `lane` on the best direction that was found, and gaps along that. Points of both
  /// are no further apart than the root of this square, in the units of the tested node, as gaps
  /// are.
  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static void write(AnyTag tag, Planes<lanes>& planes, FoundPlanes<lanes>& found,
                               std::size_t lane, hn::Vec<AnyTag> gap,
                               const hn::Vec<AnyTag> (&normal)[3], hn::Vec<AnyTag> squared_distance,
                               float unit_of_tested) {
    const hn::Rebind<std::int16_t, AnyTag> halves;
    const auto shorter = hn::Set(tag, Planes<lanes>::kLength * Planes<lanes>::kUnit);
    // Rounding to units changes a normal by kLongest at most; what it is off by comes on top.
    constexpr float kLongest = 0.87f * Planes<lanes>::kUnit;
    auto off = hn::Set(tag, kDirectionError * (kDirectionError + 2 * kLongest));
    for (int i = 0; i < 3; ++i) {
      const auto rounded = hn::NearestInt(hn::Mul(normal[i], hn::Set(tag, Planes<lanes>::kLength)));
      hn::StoreU(hn::DemoteTo(halves, rounded), halves, planes.normal[i] + lane);
      const auto stored = hn::ConvertTo(tag, rounded);
      hn::Store(stored, tag, found.normal[i] + lane);
      const auto change =
          hn::MulSub(stored, hn::Set(tag, Planes<lanes>::kUnit), hn::Mul(normal[i], shorter));
      off = hn::MulAdd(change, change, off);
    }
    const auto loss = root_above(tag, hn::Mul(off, squared_distance));
    store_gaps(tag, found, lane, gap, hn::MulSub(gap, shorter, loss), squared_distance,
               unit_of_tested);
  }

  template <typename AnyTag>
  HWY_INLINE static hn::Vec<AnyTag> best_of(const BestGap<AnyTag>& best,
                                            hn::Vec<AnyTag> (&normal)[3]) {
    return best.shortened(normal);
  }
};

/// Stores and reads the planes of a front that is to tell how far things are apart.
template <>
struct PlaneStore<FrontKind::Distance> {
  template <std::size_t lanes>
  using Planes = FrontPlanes<lanes, FrontKind::Distance>;

  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE static hn::Vec<AnyTag> read(AnyTag tag, const Planes<lanes>& planes, std::size_t lane,
                                         hn::Vec<AnyTag> (&normal)[3]) {
    for (int i = 0; i < 3; ++i)
      normal[i] = hn::Load(tag, planes.normal[i] + lane);
    return hn::Load(tag, planes.gap + lane);
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
    const auto loss = hn::Mul(root_above(tag, squared_distance), hn::Set(tag, kDirectionError));
    store_gaps(tag, found, lane, gap, hn::Sub(gap, loss), squared_distance, unit_of_tested);
  }

  template <typename AnyTag>
  HWY_INLINE static hn::Vec<AnyTag> best_of(const BestGap<AnyTag>& best,
                                            hn::Vec<AnyTag> (&normal)[3]) {
    return best.normalized(normal);
  }
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
