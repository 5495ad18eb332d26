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
  float middle;  // from the box's
  float half;
  float margin;  // what all errors cost along the normal of a tested node's slab
};

/// `padding` is that of the query box in the tested node.
HWY_INLINE QuerySlab slab_of(const WideNode& node, std::uint32_t lane, float scale, float padding) {
  QuerySlab slab;
  float reach = node.half[2][lane] * scale;
  for (int k = 0; k < 2; ++k) {
    slab.slope[k] = WideNode::slope_of(node.slope[k][lane]);
    reach += std::abs(slab.slope[k]) * (node.half[k][lane] * scale);
  }
  slab.middle = static_cast<float>(node.slab_middle[lane]) * WideNode::kSlabMiddleUnit * reach;
  slab.half = (static_cast<float>(node.slab_half[lane]) + 1) * WideNode::kSlabHalfUnit * reach;
  slab.margin = kSlabMargins * padding;
  return slab;
}

/// From `lane` on, for boxes of these half extents.
struct SlabLanes {
  Lanes slope[2];
  Lanes middle;  // from the boxes'
  Lanes half;

  HWY_INLINE SlabLanes(const WideNode& node, std::size_t lane, const Lanes (&box_half)[3]) {
    const Tag tag;
    Lanes reach = box_half[2];
    for (int k = 0; k < 2; ++k) {
      const Lanes q = floats(hn::LoadU(hn::Rebind<std::int8_t, Tag>(), node.slope[k] + lane));
      slope[k] = hn::Mul(hn::Mul(q, hn::Abs(q)), hn::Set(tag, WideNode::kSlopeUnit));
      reach = hn::MulAdd(hn::Abs(slope[k]), box_half[k], reach);
    }
    const Lanes at = floats(hn::LoadU(hn::Rebind<std::int8_t, Tag>(), node.slab_middle + lane));
    middle = hn::Mul(hn::Mul(at, hn::Set(tag, WideNode::kSlabMiddleUnit)), reach);
    const Lanes steps = floats(hn::LoadU(hn::Rebind<std::uint8_t, Tag>(), node.slab_half + lane));
    const Lanes unit = hn::Set(tag, WideNode::kSlabHalfUnit);
    half = hn::Mul(hn::MulAdd(steps, unit, unit), reach);
  }

 private:
  template <typename Bytes>
  static HWY_INLINE Lanes floats(Bytes bytes) {
    return hn::ConvertTo(Tag(), hn::PromoteTo(hn::Rebind<std::int32_t, Tag>(), bytes));
  }
};

// What a tested node holds is within `half` of the middle of its slab, along the slab's normal n. A
// point of the query box is sum s_k g_k from its middle, g_k its axes, and with m_k = n . g_k that
// is
//
//   sum s_k m_k = m_2 (a s_0 + b s_1 + s_2) + (m_0 - a m_2) s_0 + (m_1 - b m_2) s_1
//
// along n, a and b the slopes of the query box's own slab, which bounds the first bracket: whatever
// the other two cost, little where both surfaces are nearly parallel, both slabs are as thin as
// they are.
struct SlabGap {
  Lanes offset;  // from the middle of the tested node's slab to that of the query box's, along n
  Lanes reach;   // of both

  template <typename AnyQuery>
  HWY_INLINE SlabGap(const SlabLanes& tested, const Lanes (&way)[3], const AnyQuery& query,
                     const QuerySlab& slab) {
    const Tag tag;
    Lanes m[3];
    for (int k = 0; k < 3; ++k) {
      m[k] = hn::MulAdd(tested.slope[0], hn::Set(tag, query.axis(k, 0)),
                        hn::MulAdd(tested.slope[1], hn::Set(tag, query.axis(k, 1)),
                                   hn::Set(tag, query.axis(k, 2))));
    }
    reach = hn::MulAdd(hn::Abs(m[2]), hn::Set(tag, slab.half),
                       hn::Add(tested.half, hn::Set(tag, slab.margin)));
    for (int k = 0; k < 2; ++k) {
      const Lanes rest = hn::NegMulAdd(m[2], hn::Set(tag, slab.slope[k]), m[k]);
      reach = hn::MulAdd(hn::Abs(rest), hn::Set(tag, query.half(k)), reach);
    }
    const Lanes along =
        hn::MulAdd(tested.slope[0], way[0], hn::MulAdd(tested.slope[1], way[1], way[2]));
    offset = hn::Sub(hn::MulAdd(m[2], hn::Set(tag, slab.middle), along), tested.middle);
  }
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
