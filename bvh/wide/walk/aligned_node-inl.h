// The boxes of a node of a wide tree along axes that both trees share. Included once for each SIMD
// target.

#if defined(GRAZE_BVH_ALIGNED_NODE) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_ALIGNED_NODE
#undef GRAZE_BVH_ALIGNED_NODE
#else
#define GRAZE_BVH_ALIGNED_NODE
#endif

#include <graze/bvh/wide/lanes/query_gaps-inl.h>
#include <graze/bvh/wide/lanes/query_leaf-inl.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/bvh/wide/walk/aligned_boxes.h>
#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Where a point of a tree's frame lies along a shared axis.
HWY_INLINE double aligned_at(const AlignedTransform& transform, int axis,
                             const double (&point)[3]) {
  const double(&z)[3] = transform.axes[axis];
  return (z[0] * point[0] + z[1] * point[1] + z[2] * point[2]) + transform.offset[axis];
}

/// Children of a node along one axis.
struct AlignedLanes {
  Lanes low;
  Lanes high;
};

/// A node's axes and origin along the first so many shared axes.
template <int kAxes>
struct NodeAlong {
  alignas(16) float axes[kAxes][4];  ///< [shared axis][axis of the node]
  double origin[kAxes];

  HWY_INLINE NodeAlong(const WideNode& node, const AlignedTransform& transform) {
    for (int k = 0; k < kAxes; ++k)
      origin[k] = aligned_at(transform, k, node.origin);
    for (std::size_t part = 0; part < 4; part += hn::Lanes(FourTag())) {
      const Rows rows(node, part);
      for (int k = 0; k < kAxes; ++k) {
        hn::Store(rows.combined(transform.rows[k][0], transform.rows[k][1], transform.rows[k][2]),
                  FourTag(), axes[k] + part);
      }
    }
  }
};

/// Boxes of children along the first so many of the axes.
template <int kAxes>
HWY_INLINE void set_lanes_along(AlignedLanes (&lanes)[kAxes], const WideNode& node,
                                std::size_t part, const NodeAlong<kAxes>& along,
                                const AlignedTransform& transform) {
  const Tag tag;
  Lanes half[3], centre[3];
  Lanes size = hn::Zero(tag);
  for (int j = 0; j < 3; ++j) {
    half[j] = hn::Load(tag, node.half[j] + part);
    centre[j] = hn::Load(tag, node.centre[j] + part);
    size = hn::Add(size, hn::Add(half[j], hn::Abs(centre[j])));
  }
  for (int k = 0; k < kAxes; ++k) {
    const auto origin = static_cast<float>(along.origin[k]);
    Lanes middle = hn::Set(tag, origin);
    Lanes radius = hn::MulAdd(hn::Set(tag, kAlignedError * transform.unit), size,
                              hn::Set(tag, kAlignedError * std::abs(origin) + transform.slack));
    for (int j = 0; j < 3; ++j) {
      middle = hn::MulAdd(hn::Set(tag, along.axes[k][j]), centre[j], middle);
      radius = hn::MulAdd(hn::Set(tag, std::abs(along.axes[k][j])), half[j], radius);
    }
    lanes[k] = {hn::Sub(middle, radius), hn::Add(middle, radius)};
  }
}

/// The interval that something takes up along the first axis.
struct AlignedInterval {
  float low;
  float high;
};

/// The interval of all that the children of a node hold.
HWY_INLINE AlignedInterval interval_of_children(const WideNode& node,
                                                const AlignedTransform& transform) {
  const Tag tag;
  const NodeAlong<1> along(node, transform);
  Lanes least = hn::Set(tag, std::numeric_limits<float>::infinity());
  Lanes most = hn::Neg(least);
  for (std::size_t part = 0; part < node.count; part += hn::Lanes(tag)) {
    AlignedLanes lanes[1];
    set_lanes_along(lanes, node, part, along, transform);
    const auto is_there = hn::FirstN(tag, node.count - part);
    least = hn::IfThenElse(is_there, hn::Min(least, lanes[0].low), least);
    most = hn::IfThenElse(is_there, hn::Max(most, lanes[0].high), most);
  }
  return {hn::GetLane(hn::MinOfLanes(tag, least)), hn::GetLane(hn::MaxOfLanes(tag, most))};
}

/// The interval of the corners of a leaf; `origin` is the coordinate of its treelet's origin.
HWY_INLINE AlignedInterval interval_of_leaf(const WideTree::Treelet& treelet, std::uint32_t link,
                                            float origin, const AlignedTransform& transform) {
  const FourTag tag;
  const std::uint32_t count = ChildLink::count(link);
  const float* rows = rows_of(treelet, link);
  Four least = hn::Set(tag, std::numeric_limits<float>::infinity());
  Four most = hn::Neg(least);
  for (std::uint32_t part = 0; part < count; part += static_cast<std::uint32_t>(hn::Lanes(tag))) {
    const auto is_there = hn::FirstN(tag, count - part);
    for (std::uint32_t c = 0; c < 3; ++c) {
      const auto row = [&](std::uint32_t i)
                           HWY_ATTR { return hn::LoadU(tag, rows + (3 * c + i) * count + part); };
      const Four at = hn::MulAdd(row(0), hn::Set(tag, transform.rows[0][0]),
                                 hn::MulAdd(row(1), hn::Set(tag, transform.rows[0][1]),
                                            hn::Mul(row(2), hn::Set(tag, transform.rows[0][2]))));
      least = hn::IfThenElse(is_there, hn::Min(least, at), least);
      most = hn::IfThenElse(is_there, hn::Max(most, at), most);
    }
  }
  const float margin =
      kAlignedError * (std::abs(origin) + treelet.largest_coordinate * transform.unit) +
      transform.slack;
  return {(hn::GetLane(hn::MinOfLanes(tag, least)) + origin) - margin,
          (hn::GetLane(hn::MaxOfLanes(tag, most)) + origin) + margin};
}

/// Boxes of the children.
inline HWY_NOINLINE void set_aligned_boxes(AlignedNode& aligned, const WideNode& node,
                                           const AlignedTransform& transform) {
  const Tag tag;
  const NodeAlong<3> along(node, transform);
  for (std::size_t part = 0; part < WideNode::kWidth; part += hn::Lanes(tag)) {
    AlignedLanes lanes[3];
    set_lanes_along(lanes, node, part, along, transform);
    for (int k = 0; k < 3; ++k) {
      hn::Store(lanes[k].low, tag, aligned.low[k] + part);
      hn::Store(lanes[k].high, tag, aligned.high[k] + part);
    }
  }
}

/// Along the first axis, where it matters, as what they hold reaches: much of a box along a node's
/// axes is empty.
inline HWY_NOINLINE void set_aligned_node(AlignedNode& aligned, const WideTree& tree,
                                          const WideChildRef& child,
                                          const AlignedTransform& transform) {
  const WideNode& node = *child.node;
  set_aligned_boxes(aligned, node, transform);
  const WideTree::Treelet& treelet = tree.treelet(child.treelet);
  const auto origin = static_cast<float>(aligned_at(transform, 0, treelet.origin));
  for (std::uint32_t lane = 0; lane < node.count; ++lane) {
    const std::uint32_t link = node.child[lane];
    if (ChildLink::is_treelet(link)) continue;  // it may not be built
    const AlignedInterval interval =
        ChildLink::is_leaf(link)
            ? interval_of_leaf(treelet, link, origin, transform)
            : interval_of_children(*(&node + ChildLink::index(link)), transform);
    aligned.low[0][lane] = std::max(aligned.low[0][lane], interval.low);
    aligned.high[0][lane] = std::min(aligned.high[0][lane], interval.high);
  }
}

/// Lower bounds of the squared distances of a query box and the children of a tested node.
HWY_INLINE void set_aligned_bounds(float (&bounds)[WideNode::kWidth], const AlignedNode& tested,
                                   const AlignedNode& query, std::uint32_t lane) {
  const Tag tag;
  for (std::size_t part = 0; part < WideNode::kWidth; part += hn::Lanes(tag)) {
    Lanes square = hn::Zero(tag);
    for (int k = 0; k < 3; ++k) {
      const Lanes above =
          hn::Sub(hn::Load(tag, tested.low[k] + part), hn::Set(tag, query.high[k][lane]));
      const Lanes below =
          hn::Sub(hn::Set(tag, query.low[k][lane]), hn::Load(tag, tested.high[k] + part));
      const Lanes gap = known(tag, hn::Max(above, below));
      square = hn::MulAdd(gap, gap, square);
    }
    hn::Store(square, tag, bounds + part);
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
