// This tells which children of a node a ray may meet. It is included once for each SIMD target.

#if defined(GRAZE_BVH_RAY_BOXES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_RAY_BOXES
#undef GRAZE_BVH_RAY_BOXES
#else
#define GRAZE_BVH_RAY_BOXES
#endif

#include <graze/bvh/rays/ray_tree_walk.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using RayTag = hn::CappedTag<float, RayNode::kWidth>;
using RayLanes = hn::Vec<RayTag>;

template <typename Mask>
HWY_INLINE std::uint32_t ray_bits(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(RayTag(), mask, bits);
  return bits[0];
}

/// A ray's numbers in the lanes of registers, as boxes are compared with them.
class RayBoxes {
 public:
  HWY_INLINE explicit RayBoxes(const RayWalkState& ray)
      : near_row_(ray.near_row), far_row_(ray.far_row) {
    const RayTag tag;
    for (std::size_t k = 0; k < 3; ++k) {
      inverse_[k] = hn::Set(tag, ray.inverse[k]);
      near_[k] = hn::Set(tag, ray.near[k]);
      far_[k] = hn::Set(tag, ray.far[k]);
    }
  }

  /// Returns the bits of the children that the ray is not sure to miss before the limit. Writes to
  /// `enters` values that are not above any s in them.
  HWY_INLINE std::uint32_t near_children(const RayNode& node, float limit, float* enters) const {
    const RayTag tag;
    const float* const rows = node.box[0];
    std::uint32_t bits = 0;
    for (std::size_t lane = 0; lane < RayNode::kWidth; lane += hn::Lanes(tag)) {
      RayLanes enter[3], leave[3];
      for (std::size_t k = 0; k < 3; ++k) {
        enter[k] = hn::MulAdd(hn::Load(tag, rows + near_row_[k] + lane), inverse_[k], near_[k]);
        leave[k] = hn::MulAdd(hn::Load(tag, rows + far_row_[k] + lane), inverse_[k], far_[k]);
      }
      const RayLanes last = hn::Max(hn::Max(enter[0], enter[1]), hn::Max(enter[2], hn::Zero(tag)));
      const RayLanes first =
          hn::Min(hn::Min(leave[0], leave[1]), hn::Min(leave[2], hn::Set(tag, limit)));
      hn::Store(last, tag, enters + lane);
      bits |= ray_bits(hn::Le(last, first)) << lane;
    }
    return bits;
  }

 private:
  RayLanes inverse_[3], near_[3], far_[3];
  const std::size_t (&near_row_)[3];
  const std::size_t (&far_row_)[3];
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
