// Which children of a node a ray may meet. Included once for each SIMD target.

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

/// Eight bits each, as floats.
HWY_INLINE RayLanes ray_grid(const std::uint8_t* row) {
  const hn::Rebind<std::int32_t, RayTag> wide;
  const hn::Rebind<std::uint8_t, RayTag> narrow;
  return hn::ConvertTo(RayTag(), hn::PromoteTo(wide, hn::LoadU(narrow, row)));
}

/// What boxes are asked with.
class RayBoxes {
 public:
  HWY_INLINE explicit RayBoxes(const RayWalkState& ray) {
    const RayTag tag;
    for (std::size_t k = 0; k < 3; ++k) {
      origin_[k] = hn::Set(tag, ray.origin[k]);
      inverse_[k] = hn::Set(tag, ray.inverse[k]);
      padding_[k] = hn::Abs(hn::Mul(inverse_[k], hn::Set(tag, ray.padding)));
      near_[k] = ray.near_row[k] * RayNode::kWidth;
      far_[k] = ray.far_row[k] * RayNode::kWidth;
    }
  }

  /// The bits of the children that the ray is not sure to miss before the limit, and values that
  /// are not above any s in them.
  HWY_INLINE std::uint32_t near_children(const RayNode& node, float limit, float* enters) const {
    const RayTag tag;
    const std::uint8_t* const rows = node.box[0];
    RayLanes step[3], near[3], far[3];
    for (std::size_t k = 0; k < 3; ++k) {
      step[k] = hn::Mul(hn::Set(tag, node.scale[k]), inverse_[k]);
      const RayLanes from = hn::Sub(hn::Set(tag, node.origin[k]), origin_[k]);
      near[k] = hn::MulSub(from, inverse_[k], padding_[k]);
      far[k] = hn::MulAdd(from, inverse_[k], padding_[k]);
    }
    std::uint32_t bits = 0;
    for (std::size_t lane = 0; lane < RayNode::kWidth; lane += hn::Lanes(tag)) {
      RayLanes enter[3], leave[3];
      for (std::size_t k = 0; k < 3; ++k) {
        enter[k] = hn::MulAdd(ray_grid(rows + near_[k] + lane), step[k], near[k]);
        leave[k] = hn::MulAdd(ray_grid(rows + far_[k] + lane), step[k], far[k]);
      }
      const RayLanes last = hn::Max(hn::Max(enter[0], enter[1]), hn::Max(enter[2], hn::Zero(tag)));
      const RayLanes first =
          hn::Min(hn::Min(leave[0], leave[1]), hn::Min(leave[2], hn::Set(tag, limit)));
      hn::StoreU(last, tag, enters + lane);
      bits |= ray_bits(hn::Le(last, first)) << lane;
    }
    return bits & node.lanes();
  }

 private:
  RayLanes origin_[3], inverse_[3], padding_[3];
  std::size_t near_[3], far_[3];
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
