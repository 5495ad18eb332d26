// The corners of a leaf of one wide tree beside those of the other, and its primitives one by one
// against the boxes of a node of the other. Included once for each SIMD target.

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
  float error;       ///< of each coordinate of a difference of corners, of this leaf or of both
  float sign_error;  ///< the same; infinite where products of three differences could overflow
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
  const float sizes = query.largest_coordinate * scale + tested.largest_coordinate + largest;
  leaf.error = transform.slack + kCornerError * sizes;
  leaf.sign_error =
      sizes < kLargestPlaneExtent ? leaf.error : std::numeric_limits<float>::infinity();
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

/// The primitives of a leaf along the axes of a tested node, a lane for each: the box around each
/// there, and the interval that it takes up along its normal. All of it is widened by what rounding
/// may have changed (wide_bounds.h).
struct LeafInNode {
  alignas(16) float low[3][4];
  alignas(16) float high[3][4];
  alignas(16) float normal[3][4];
  alignas(16) float below[4];
  alignas(16) float above[4];
};

HWY_INLINE void set_leaf_in_node(LeafInNode& in_node, const QueryLeaf& leaf, const WideNode& tested,
                                 const double (&treelet_origin)[3]) {
  const FourTag tag;
  float start[3];  // from the origin of the tested node to that of its treelet
  for (int i = 0; i < 3; ++i)
    start[i] = static_cast<float>(treelet_origin[i] - tested.origin[i]);
  const Four error = hn::Set(tag, kLeafInNodeError * leaf.error);
  for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
    Four p[3][3];
    for (int c = 0; c < 3; ++c) {
      Four offset[3];
      for (int i = 0; i < 3; ++i)
        offset[i] = hn::Add(hn::Load(tag, leaf.corner[c][i] + part), hn::Set(tag, start[i]));
      for (int k = 0; k < 3; ++k) {
        p[c][k] = hn::MulAdd(offset[0], hn::Set(tag, tested.axes[0][k]),
                             hn::MulAdd(offset[1], hn::Set(tag, tested.axes[1][k]),
                                        hn::Mul(offset[2], hn::Set(tag, tested.axes[2][k]))));
      }
    }
    Four e[3], f[3], normal[3];
    for (int k = 0; k < 3; ++k) {
      hn::Store(hn::Sub(hn::Min(hn::Min(p[0][k], p[1][k]), p[2][k]), error), tag,
                in_node.low[k] + part);
      hn::Store(hn::Add(hn::Max(hn::Max(p[0][k], p[1][k]), p[2][k]), error), tag,
                in_node.high[k] + part);
      e[k] = hn::Sub(p[1][k], p[0][k]);
      f[k] = hn::Sub(p[2][k], p[0][k]);
    }
    Four size = hn::Zero(tag);
    for (int k = 0; k < 3; ++k) {
      const int k1 = (k + 1) % 3;
      const int k2 = (k + 2) % 3;
      normal[k] = hn::MulSub(e[k1], f[k2], hn::Mul(e[k2], f[k1]));
      hn::Store(normal[k], tag, in_node.normal[k] + part);
      size = hn::Add(size, hn::Abs(normal[k]));
    }
    Four below, above;
    for (int c = 0; c < 3; ++c) {
      const Four height = hn::MulAdd(normal[0], p[c][0],
                                     hn::MulAdd(normal[1], p[c][1], hn::Mul(normal[2], p[c][2])));
      below = c == 0 ? height : hn::Min(below, height);
      above = c == 0 ? height : hn::Max(above, height);
    }
    const Four margin = hn::MulAdd(size, error, hn::Set(tag, kWideUnderflow));
    hn::Store(hn::Sub(below, margin), tag, in_node.below + part);
    hn::Store(hn::Add(above, margin), tag, in_node.above + part);
  }
}

/// The bits of the children that some of the first `count` primitives are not proved apart from.
HWY_INLINE std::uint32_t near_primitives_of(const LeafInNode& leaf, std::uint32_t count,
                                            const WideNode& tested) {
  const Tag tag;
  std::uint32_t near = 0;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes centre[3], half[3], low[3], high[3];
    for (int k = 0; k < 3; ++k) {
      centre[k] = hn::Load(tag, tested.centre[k] + lane);
      half[k] = hn::Load(tag, tested.half[k] + lane);
      low[k] = hn::Sub(centre[k], half[k]);
      high[k] = hn::Add(centre[k], half[k]);
    }
    auto are_apart = hn::Eq(low[0], low[0]);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Lanes n[3] = {hn::Set(tag, leaf.normal[0][i]), hn::Set(tag, leaf.normal[1][i]),
                          hn::Set(tag, leaf.normal[2][i])};
      const Lanes height =
          hn::MulAdd(n[0], centre[0], hn::MulAdd(n[1], centre[1], hn::Mul(n[2], centre[2])));
      const Lanes radius =
          hn::MulAdd(hn::Abs(n[0]), half[0],
                     hn::MulAdd(hn::Abs(n[1]), half[1], hn::Mul(hn::Abs(n[2]), half[2])));
      auto apart = hn::Or(hn::Gt(hn::Sub(height, radius), hn::Set(tag, leaf.above[i])),
                          hn::Lt(hn::Add(height, radius), hn::Set(tag, leaf.below[i])));
      for (int k = 0; k < 3; ++k) {
        apart = hn::Or(apart, hn::Or(hn::Gt(low[k], hn::Set(tag, leaf.high[k][i])),
                                     hn::Lt(high[k], hn::Set(tag, leaf.low[k][i]))));
      }
      are_apart = hn::And(are_apart, apart);
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, hn::Not(are_apart), bits);
    near |= std::uint32_t{bits[0]} << lane;
  }
  return near;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
