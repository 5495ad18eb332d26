// Which primitives of two leaves are not proved apart. Included once for each SIMD target.

#if defined(GRAZE_BVH_NEAR_PRIMITIVES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_NEAR_PRIMITIVES
#undef GRAZE_BVH_NEAR_PRIMITIVES
#else
#define GRAZE_BVH_NEAR_PRIMITIVES
#endif

#include <graze/bvh/wide/lanes/pair_lanes-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Whether the corners of one triangle are all on one side of the plane of another, further from it
/// than the bound.
template <typename AnyTag>
HWY_INLINE auto is_on_one_side(const Heights<AnyTag>& heights, hn::Vec<AnyTag> bound) {
  return hn::Or(hn::Gt(heights.low, bound), hn::Lt(heights.high, hn::Neg(bound)));
}

/// The bits of the pairs that are not proved apart: by boxes along the axes of the tested node's
/// tree and by the planes of both.
HWY_INLINE std::uint32_t near_primitives(const LeafLanes& tested, const QueryLeaf& query) {
  const PairTag tag;
  std::uint32_t near = 0;
  const auto error = hn::Set(tag, query.error);
  for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
    const PairLanes<PairTag> lanes(first);
    const PairBoxes<PairTag> boxes(lanes, tested, query);
    auto apart = hn::Gt(boxes.gap[0], error);
    for (int i = 1; i < 3; ++i)
      apart = hn::Or(apart, hn::Gt(boxes.gap[i], error));
    if (hn::AllTrue(tag, apart)) continue;
    const auto bound = height_error(tag, boxes.extent, error);
    const PairTriangles<PairTag> triangles(lanes, tested, query);
    const Heights<PairTag> of_query(triangles.tested, triangles.query);
    const Heights<PairTag> of_tested(triangles.query, triangles.tested);
    apart = hn::Or(apart, is_on_one_side(of_query, bound));
    apart = hn::Or(apart, is_on_one_side(of_tested, bound));
    near |= bits_of(tag, hn::Not(apart)) << first;
  }
  return near;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
