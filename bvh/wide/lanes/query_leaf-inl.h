// The corners of a leaf of one wide tree beside those of the other. Included once for each SIMD
// target.

#if defined(GRAZE_BVH_QUERY_LEAF) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_QUERY_LEAF
#undef GRAZE_BVH_QUERY_LEAF
#else
#define GRAZE_BVH_QUERY_LEAF
#endif

#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/tree/corner_rows.h>
#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// A leaf, one lane for each primitive.
struct LeafLanes {
  alignas(16) float corner[3][3][4];  ///< [corner][component]
  alignas(16) float normal[3][4];
  alignas(16) float low[3][4];
  alignas(16) float high[3][4];
};

/// Of four primitives at a time: corners, boxes and normals.
HWY_INLINE void set_lanes(LeafLanes& leaf, std::size_t part, const Four (&p)[3][3]) {
  const FourTag tag;
  Four e[3], f[3];
  for (int i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c)
      hn::Store(p[c][i], tag, leaf.corner[c][i] + part);
    e[i] = hn::Sub(p[1][i], p[0][i]);
    f[i] = hn::Sub(p[2][i], p[0][i]);
    hn::Store(hn::Min(hn::Min(p[0][i], p[1][i]), p[2][i]), tag, leaf.low[i] + part);
    hn::Store(hn::Max(hn::Max(p[0][i], p[1][i]), p[2][i]), tag, leaf.high[i] + part);
  }
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    hn::Store(hn::MulSub(e[i1], f[i2], hn::Mul(e[i2], f[i1])), tag, leaf.normal[i] + part);
  }
}

/// Where the rows of a leaf of a treelet begin. Lanes beyond its count hold what is behind them.
HWY_INLINE const float* rows_of(const WideTree::Treelet& treelet, std::uint32_t link) {
  return treelet.corners.data() + CornerRows::kRows * ChildLink::first(link);
}

HWY_INLINE void set_tested_leaf(LeafLanes& leaf, const WideTree::Treelet& tested,
                                std::uint32_t link) {
  const FourTag tag;
  const std::uint32_t count = ChildLink::count(link);
  const float* rows = rows_of(tested, link);
  for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
    Four p[3][3];
    for (std::uint32_t c = 0; c < 3; ++c) {
      for (std::uint32_t i = 0; i < 3; ++i)
        p[c][i] = hn::LoadU(tag, rows + (3 * c + i) * count + part);
    }
    set_lanes(leaf, part, p);
  }
}

/// The leaf that a query box bounds, in the coordinates of the tested node's treelet.
struct QueryLeaf : LeafLanes {
  float error;  ///< of each coordinate of a difference of corners, one of either leaf
};

HWY_INLINE void set_query_leaf(QueryLeaf& leaf, const WideTree::Treelet& query, std::uint32_t link,
                               const WideTree::Treelet& tested, const TreeTransform& transform) {
  const FourTag tag;
  const std::uint32_t count = ChildLink::count(link);
  const float* rows = rows_of(query, link);
  const auto scale = static_cast<float>(transform.scale);
  float offset[3];
  float largest = 0;
  for (int i = 0; i < 3; ++i) {
    const double turned = transform.rotation[i][0] * query.origin[0] +
                          transform.rotation[i][1] * query.origin[1] +
                          transform.rotation[i][2] * query.origin[2];
    offset[i] = static_cast<float>((turned * transform.scale + transform.translation[i]) -
                                   tested.origin[i]);
    largest = std::max(largest, std::abs(offset[i]));
  }
  leaf.error = transform.slack + kCornerError * (query.largest_coordinate * scale +
                                                 tested.largest_coordinate + largest);
  for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
    Four p[3][3];
    for (std::uint32_t c = 0; c < 3; ++c) {
      const Four x = hn::LoadU(tag, rows + (3 * c + 0) * count + part);
      const Four y = hn::LoadU(tag, rows + (3 * c + 1) * count + part);
      const Four z = hn::LoadU(tag, rows + (3 * c + 2) * count + part);
      for (int i = 0; i < 3; ++i) {
        const Four turned =
            hn::MulAdd(x, hn::Set(tag, transform.columns[0][i]),
                       hn::MulAdd(y, hn::Set(tag, transform.columns[1][i]),
                                  hn::Mul(z, hn::Set(tag, transform.columns[2][i]))));
        p[c][i] = hn::MulAdd(turned, hn::Set(tag, scale), hn::Set(tag, offset[i]));
      }
    }
    set_lanes(leaf, part, p);
  }
}

/// How far a determinant of differences up to `extent` can be off, in each lane (wide_bounds.h).
/// Where its products could overflow nothing is known.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> height_error(AnyTag tag, hn::Vec<AnyTag> extent, hn::Vec<AnyTag> error) {
  const auto bound = hn::MulAdd(
      hn::Mul(extent, extent),
      hn::MulAdd(extent, hn::Set(tag, kPlaneRounding), hn::Mul(error, hn::Set(tag, kPlaneError))),
      hn::Set(tag, kWideUnderflow));
  return hn::IfThenElse(hn::Lt(extent, hn::Set(tag, kLargestPlaneExtent)), bound,
                        hn::Set(tag, std::numeric_limits<float>::infinity()));
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
