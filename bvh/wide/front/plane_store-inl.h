// Planes of a front as they are stored and read: what rounding their directions costs. Included
// once for each SIMD target.

#if defined(GRAZE_BVH_PLANE_STORE) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_PLANE_STORE
#undef GRAZE_BVH_PLANE_STORE
#else
#define GRAZE_BVH_PLANE_STORE
#endif

#include <graze/bvh/wide/front/best_gap-inl.h>
#include <graze/bvh/wide/front/front_planes.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Covers kBoundGrowth, and the rounding of roots and products.
inline constexpr float kShrink = 1 - 0x1p-13f;

/// Of how far apart things are, what a direction costs that is rounded after the gap along it was
/// found: 15 u for the directions of boxes, with the turn to the tree's axes; u = 2^-24.
inline constexpr float kDirectionError = 0x1p-19f;

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

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
