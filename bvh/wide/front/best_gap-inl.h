// The largest of several gaps between two things, and the direction along which it is. Included
// once for each SIMD target.

#if defined(GRAZE_BVH_BEST_GAP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_BEST_GAP
#undef GRAZE_BVH_BEST_GAP
#else
#define GRAZE_BVH_BEST_GAP
#endif

#include <graze/bvh/wide/lanes/query_gaps-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// What is further counts as so far.
inline constexpr float kFarthest = 0x1p60f;

/// What estimates of reciprocals and of reciprocal roots are off by at most, on any target.
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

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
