// All pairs of the primitives of two leaves, a lane each, and which of them are not proved apart.
// Included once for each SIMD target.

#if defined(GRAZE_BVH_PAIR_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_PAIR_LANES
#undef GRAZE_BVH_PAIR_LANES
#else
#define GRAZE_BVH_PAIR_LANES
#endif

#include <graze/bvh/wide/lanes/query_leaf-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

// Pair 4 i + j is that of primitive i of the tested leaf and primitive j of the query's leaf.
inline constexpr std::size_t kLeafPairs = ChildLink::kMaxLeafSize * ChildLink::kMaxLeafSize;
using PairTag = hn::CappedTag<float, kLeafPairs>;

/// The bits of the pairs of two leaves of so many primitives.
HWY_INLINE std::uint32_t pairs_of(std::uint32_t tested, std::uint32_t queries) {
  return 0x1111u * ((1u << queries) - 1) & ((1u << 4 * tested) - 1);
}

/// The bits of the lanes of a mask, up to sixteen.
template <typename AnyTag, typename Mask>
HWY_INLINE std::uint32_t bits_of(AnyTag tag, Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, mask, bits);
  return std::uint32_t{bits[0]} | std::uint32_t{bits[1]} << 8;
}

/// The reverse, of the lowest bits.
template <typename AnyTag>
HWY_INLINE auto lanes_of(AnyTag tag, std::uint32_t lanes) {
  const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes),
                                static_cast<std::uint8_t>(lanes >> 8)};
  return hn::LoadMaskBits(tag, bits);
}

/// Values of the tested node's and the query box's primitives in as many pairs as there are lanes,
/// from `first` on.
template <typename AnyTag>
class PairLanes {
 public:
  using Values = hn::Vec<AnyTag>;

  HWY_INLINE explicit PairLanes(std::size_t first) : first_(first) {
    alignas(64) std::int32_t tested[kLeafPairs];
    for (std::size_t i = 0; i < hn::Lanes(AnyTag()); ++i)
      tested[i] = static_cast<std::int32_t>((first + i) / 4);
    tested_ = hn::SetTableIndices(AnyTag(), tested);
  }

  /// Of four values.
  HWY_INLINE Values tested(const float* values) const {
    const AnyTag tag;
    if constexpr (kHas128Bits) {
      if (hn::Lanes(tag) > 4) return hn::TableLookupLanes(hn::LoadDup128(tag, values), tested_);
    }
    return hn::Set(tag, values[first_ / 4]);
  }

  HWY_INLINE Values query(const float* values) const {
    const AnyTag tag;
    if constexpr (kHas128Bits) return hn::LoadDup128(tag, values);
    return hn::LoadU(tag, values + first_ % 4);
  }

 private:
  static constexpr bool kHas128Bits = HWY_TARGET != HWY_SCALAR;

  std::size_t first_;
  decltype(hn::SetTableIndices(AnyTag(), static_cast<const std::int32_t*>(nullptr))) tested_;
};

/// The boxes of pairs, along the axes of the tested node's tree.
template <typename AnyTag>
struct PairBoxes {
  hn::Vec<AnyTag> gap[3];   ///< negative where the boxes overlap
  hn::Vec<AnyTag> size[3];  ///< of the box around both: no difference of corners is larger
  hn::Vec<AnyTag> extent;   ///< the largest component of `size`

  HWY_INLINE PairBoxes(const PairLanes<AnyTag>& lanes, const LeafLanes& tested,
                       const LeafLanes& query) {
    extent = hn::Zero(AnyTag());
    for (int i = 0; i < 3; ++i) {
      const auto low = lanes.query(query.low[i]);
      const auto high = lanes.query(query.high[i]);
      const auto tested_low = lanes.tested(tested.low[i]);
      const auto tested_high = lanes.tested(tested.high[i]);
      gap[i] = hn::Max(hn::Sub(low, tested_high), hn::Sub(tested_low, high));
      size[i] = hn::Sub(hn::Max(high, tested_high), hn::Min(low, tested_low));
      extent = hn::Max(extent, size[i]);
    }
  }
};

/// The triangles of pairs.
template <typename AnyTag>
struct PairTriangles {
  struct Side {
    hn::Vec<AnyTag> corner[3][3];
    hn::Vec<AnyTag> normal[3];
  };
  Side tested;
  Side query;

  HWY_INLINE PairTriangles(const PairLanes<AnyTag>& lanes, const LeafLanes& tested_leaf,
                           const LeafLanes& query_leaf) {
    for (int i = 0; i < 3; ++i) {
      tested.normal[i] = lanes.tested(tested_leaf.normal[i]);
      query.normal[i] = lanes.query(query_leaf.normal[i]);
      for (int c = 0; c < 3; ++c) {
        tested.corner[c][i] = lanes.tested(tested_leaf.corner[c][i]);
        query.corner[c][i] = lanes.query(query_leaf.corner[c][i]);
      }
    }
  }
};

/// How far the corners of one triangle are over the plane of another, times the length of its
/// normal: the least and the most.
template <typename AnyTag>
struct Heights {
  hn::Vec<AnyTag> low;
  hn::Vec<AnyTag> high;

  using Side = typename PairTriangles<AnyTag>::Side;

  HWY_INLINE Heights(const Side& plane, const Side& other) {
    const auto& normal = plane.normal;
    const auto& point = plane.corner[0];
    for (int c = 0; c < 3; ++c) {
      const auto& corner = other.corner[c];
      const auto height = hn::MulAdd(normal[0], hn::Sub(corner[0], point[0]),
                                     hn::MulAdd(normal[1], hn::Sub(corner[1], point[1]),
                                                hn::Mul(normal[2], hn::Sub(corner[2], point[2]))));
      low = c == 0 ? height : hn::Min(low, height);
      high = c == 0 ? height : hn::Max(high, height);
    }
  }
};

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
