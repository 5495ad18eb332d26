// The slabs of children, and how far a query box is from them. Included once for each SIMD target.

#if defined(GRAZE_BVH_SLAB_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_SLAB_LANES
#undef GRAZE_BVH_SLAB_LANES
#else
#define GRAZE_BVH_SLAB_LANES
#endif

#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// The slab of a query box, in the tested node's units.
struct QuerySlab {
  float slope[2];
  float middle;  ///< from the middle of the box
  float half;
  float margin;  ///< what all errors cost along the normal of a tested node's slab
};

/// `padding` is that of the query box in the tested node.
HWY_INLINE QuerySlab slab_of(const WideNode& node, std::uint32_t lane, float scale, float padding) {
  QuerySlab slab;
  float radius = node.half[2][lane] * scale;
  for (int k = 0; k < 2; ++k) {
    slab.slope[k] = WideNode::slope_of(node.slope[k][lane]);
    radius += std::abs(slab.slope[k]) * (node.half[k][lane] * scale);
  }
  slab.middle = static_cast<float>(node.slab_middle[lane]) * WideNode::kSlabMiddleUnit * radius;
  slab.half = (static_cast<float>(node.slab_half[lane]) + 1) * WideNode::kSlabHalfUnit * radius;
  slab.margin = kSlabMargins * padding;
  return slab;
}

/// From `lane` on, for boxes of these half extents.
struct SlabLanes {
  Lanes slope[2];
  Lanes middle;  ///< from the middles of the boxes
  Lanes half;

  HWY_INLINE SlabLanes(const WideNode& node, std::size_t lane, const Lanes (&box_half)[3]) {
    const Tag tag;
    Lanes radius = box_half[2];
    for (int k = 0; k < 2; ++k) {
      const Lanes q = floats(hn::LoadU(hn::Rebind<std::int8_t, Tag>(), node.slope[k] + lane));
      slope[k] = hn::Mul(hn::Mul(q, hn::Abs(q)), hn::Set(tag, WideNode::kSlopeUnit));
      radius = hn::MulAdd(hn::Abs(slope[k]), box_half[k], radius);
    }
    const Lanes at = floats(hn::LoadU(hn::Rebind<std::int8_t, Tag>(), node.slab_middle + lane));
    middle = hn::Mul(hn::Mul(at, hn::Set(tag, WideNode::kSlabMiddleUnit)), radius);
    const Lanes steps = floats(hn::LoadU(hn::Rebind<std::uint8_t, Tag>(), node.slab_half + lane));
    const Lanes unit = hn::Set(tag, WideNode::kSlabHalfUnit);
    half = hn::Mul(hn::MulAdd(steps, unit, unit), radius);
  }

 private:
  template <typename Bytes>
  static HWY_INLINE Lanes floats(Bytes bytes) {
    return hn::ConvertTo(Tag(), hn::PromoteTo(hn::Rebind<std::int32_t, Tag>(), bytes));
  }
};

// What a child of the tested node holds is within `half` of the middle of its slab, along the
// slab's normal n. A point of the query box lies sum s_k g_k from the middle of the box, where g_k
// are its axes. With m_k = n . g_k that is
//
//   sum s_k m_k = m_2 (a s_0 + b s_1 + s_2) + (m_0 - a m_2) s_0 + (m_1 - b m_2) s_1
//
// along n, where a and b are the slopes of the query box's own slab, which bounds the first
// bracket. The other two terms are small where both surfaces are nearly parallel, so that there the
// sum is hardly larger than both slabs are thick.
struct SlabGap {
  Lanes distance;  ///< along n, from the middle of the tested slab to that of the query box's
  Lanes radii;     ///< of both slabs along n, added up

  template <typename AnyQuery>
  HWY_INLINE SlabGap(const SlabLanes& tested, const Lanes (&offset)[3], const AnyQuery& query,
                     const QuerySlab& slab) {
    const Tag tag;
    Lanes m[3];
    for (int k = 0; k < 3; ++k) {
      m[k] = hn::MulAdd(tested.slope[0], hn::Set(tag, query.axis(k, 0)),
                        hn::MulAdd(tested.slope[1], hn::Set(tag, query.axis(k, 1)),
                                   hn::Set(tag, query.axis(k, 2))));
    }
    radii = hn::MulAdd(hn::Abs(m[2]), hn::Set(tag, slab.half),
                       hn::Add(tested.half, hn::Set(tag, slab.margin)));
    for (int k = 0; k < 2; ++k) {
      const Lanes rest = hn::NegMulAdd(m[2], hn::Set(tag, slab.slope[k]), m[k]);
      radii = hn::MulAdd(hn::Abs(rest), hn::Set(tag, query.half(k)), radii);
    }
    const Lanes along =
        hn::MulAdd(tested.slope[0], offset[0], hn::MulAdd(tested.slope[1], offset[1], offset[2]));
    distance = hn::Sub(hn::MulAdd(m[2], hn::Set(tag, slab.middle), along), tested.middle);
  }
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
