// What all walks over two wide trees begin with: which child is looked at next, and its box, or the
// eight boxes of a node, along the axes of a node of the other tree. Included once for each SIMD
// target.

#if defined(GRAZE_BVH_QUERY_BOX) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_QUERY_BOX
#undef GRAZE_BVH_QUERY_BOX
#else
#define GRAZE_BVH_QUERY_BOX
#endif

#include <graze/bvh/wide/lanes/tree_transform.h>
#include <graze/bvh/wide/tree/wide_bounds.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <hwy/highway.h>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, WideNode::kWidth>;
using Lanes = hn::Vec<Tag>;

// Four values at a time, of which three count, or one by one where there are no vectors.
using FourTag = hn::CappedTag<float, 4>;
using Four = hn::Vec<FourTag>;

/// A gap as far as it is known: one that is negative is none, and so is what overflowed.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> known(AnyTag tag, hn::Vec<AnyTag> gap) {
  const auto infinity = hn::Set(tag, std::numeric_limits<float>::infinity());
  const auto is_known = hn::And(hn::Gt(gap, hn::Zero(tag)), hn::Lt(gap, infinity));
  return hn::IfThenElseZero(is_known, gap);
}

/// Three rows of which each product with a vector takes four values at a time, from `part` on.
struct Rows {
  Four row[3];

  HWY_INLINE Rows(const float (&columns)[3][4], std::size_t part) {
    for (std::size_t i = 0; i < 3; ++i)
      row[i] = hn::Load(FourTag(), columns[i] + part);
  }

  /// The components of a node's axes. What is behind the third axis means nothing.
  HWY_INLINE Rows(const WideNode& node, std::size_t part) {
    const FourTag tag;
    const float* axes = &node.axes[0][0];
#if HWY_TARGET == HWY_SCALAR
    for (std::size_t i = 0; i < 3; ++i)
      row[i] = hn::Load(tag, axes + 3 * i + std::min(part, std::size_t{2}));
#else
    static_cast<void>(part);
    row[0] = hn::LoadU(tag, axes);
    row[1] = hn::LoadU(tag, axes + 3);
    row[2] = hn::ShiftRightLanes<1>(tag, hn::LoadU(tag, axes + 5));
#endif
  }

  /// Only what no order depends on may be fused: the order of the walk is the same on every target.
  HWY_INLINE Four combined(float x, float y, float z) const {
    const FourTag tag;
    return hn::Add(hn::Add(hn::Mul(row[0], hn::Set(tag, x)), hn::Mul(row[1], hn::Set(tag, y))),
                   hn::Mul(row[2], hn::Set(tag, z)));
  }
};

/// How large the box of a child is: the sum of its half extents.
HWY_INLINE float size_of(const WideChildRef& child) {
  const WideNode& node = *child.node;
  return node.half[0][child.lane] + node.half[1][child.lane] + node.half[2][child.lane];
}

/// Whether the first of two children, which have these links, is the one to open: the larger one
/// is, unless it is a leaf. `scale` is the unit of the second one's tree in that of the first
/// one's.
HWY_INLINE bool is_first_opened(const WideChildRef& first, std::uint32_t first_link,
                                const WideChildRef& second, std::uint32_t second_link,
                                float scale) {
  return ChildLink::is_leaf(second_link) ||
         (!ChildLink::is_leaf(first_link) && size_of(first) >= size_of(second) * scale);
}

/// The first lane of the node that a link leads to.
HWY_INLINE WideChildRef first_below(const WideTree& tree, const WideChildRef& child,
                                    std::uint32_t link, TreeletCounts& counts) {
  const std::uint32_t index = ChildLink::index(link);
  if (!ChildLink::is_treelet(link)) return {child.node + index, 0, child.treelet};
  return {tree.entered(index, counts).nodes.data(), 0, index};
}

/// The bits of the children that are leaves.
HWY_INLINE std::uint32_t leaf_lanes(const WideNode& node) {
  const hn::Rebind<std::uint32_t, Tag> tag;
  const hn::Rebind<std::int32_t, Tag> signed_tag;
  std::uint32_t lanes = 0;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    // The leaf bit is the sign.
    const auto links = hn::BitCast(signed_tag, hn::Load(tag, node.child + lane));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(signed_tag, hn::Lt(links, hn::Zero(signed_tag)), bits);
    lanes |= std::uint32_t{bits[0]} << lane;
  }
  static_assert(ChildLink::is_leaf(1u << 31) && !ChildLink::is_leaf(~(1u << 31)));
  return lanes;
}

/// The one of these lanes that has the largest key: what is pushed first is looked at last.
HWY_INLINE std::uint32_t farthest(std::uint32_t lanes, const float* keys) {
  auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
  for (std::uint32_t rest = lanes & (lanes - 1); rest != 0; rest &= rest - 1) {
    const auto other = static_cast<std::uint32_t>(std::countr_zero(rest));
    if (keys[other] > keys[lane]) lane = other;
  }
  return lane;
}

HWY_INLINE std::uint32_t nearest(std::uint32_t lanes, const float* keys) {
  auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
  for (std::uint32_t rest = lanes & (lanes - 1); rest != 0; rest &= rest - 1) {
    const auto other = static_cast<std::uint32_t>(std::countr_zero(rest));
    if (keys[other] < keys[lane]) lane = other;
  }
  return lane;
}

/// A query box: a box of one tree in the frame of the other.
struct alignas(16) Query {
  float axes[3][4];  ///< [axis][component]
  float half[3];
  double middle[3];
};

/// A query box along the axes of a tested node. The last index counts the node's axes, but for
/// `half`.
struct alignas(16) QueryInNode {
  float axes[3][4];          ///< [axis of the query box][component]
  float size[3][4];          ///< the absolute values of these
  float cross_radius[3][4];  ///< of the query box, along the cross products of both boxes' axes
  float offset[4];           ///< from the node's origin to the middle of the query box
  float radius[4];           ///< of the query box, projected on the node's axes
  float half[3];             ///< half extents along its own axes, with the padding
  float padding;             ///< covers the slack and the rounding of all this
};

/// What the tests of a tested node's children read of it.
struct OneQuery {
  const QueryInNode& in_node;

  HWY_INLINE float axis(int k, int i) const { return in_node.axes[k][i]; }
  HWY_INLINE float size(int k, int i) const { return in_node.size[k][i]; }
  HWY_INLINE float cross_radius(int k, int i) const { return in_node.cross_radius[k][i]; }
  HWY_INLINE float offset(int i) const { return in_node.offset[i]; }
  HWY_INLINE float radius(int i) const { return in_node.radius[i]; }
  HWY_INLINE float half(int k) const { return in_node.half[k]; }
};

HWY_INLINE void set_query(Query& query, const WideNode& node, std::uint32_t lane,
                          const TreeTransform& transform) {
  const double c[3] = {node.centre[0][lane], node.centre[1][lane], node.centre[2][lane]};
  double middle[3];
  for (int i = 0; i < 3; ++i) {
    middle[i] =
        node.origin[i] + (node.axes[i][0] * c[0] + node.axes[i][1] * c[1] + node.axes[i][2] * c[2]);
  }
  for (int i = 0; i < 3; ++i) {
    query.middle[i] = (transform.rotation[i][0] * middle[0] + transform.rotation[i][1] * middle[1] +
                       transform.rotation[i][2] * middle[2]) *
                          transform.scale +
                      transform.translation[i];
    query.half[i] = node.half[i][lane] * static_cast<float>(transform.scale);
  }
  for (std::size_t part = 0; part < 4; part += hn::Lanes(FourTag())) {
    const Rows rows(transform.columns, part);
    for (int k = 0; k < 3; ++k) {
      hn::Store(rows.combined(node.axes[0][k], node.axes[1][k], node.axes[2][k]), FourTag(),
                query.axes[k] + part);
    }
  }
}

HWY_INLINE void set_query_in_node(QueryInNode& in_node, const Query& query, const WideNode& tested,
                                  float slack) {
  const FourTag tag;
  const float padding =
      slack + kComparisonError * ((query.half[0] + query.half[1]) + query.half[2]);
  in_node.padding = padding;
  float from_origin[3];
  for (int k = 0; k < 3; ++k) {
    from_origin[k] = static_cast<float>(query.middle[k] - tested.origin[k]);
    in_node.half[k] = query.half[k] + padding;
  }
  for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
    const Rows rows(tested, part);
    Four size[3];
    Four radius = hn::Set(tag, padding);
    for (int k = 0; k < 3; ++k) {
      const Four axis = rows.combined(query.axes[k][0], query.axes[k][1], query.axes[k][2]);
      size[k] = hn::Abs(axis);
      hn::Store(axis, tag, in_node.axes[k] + part);
      hn::Store(size[k], tag, in_node.size[k] + part);
      radius = hn::MulAdd(hn::Set(tag, query.half[k]), size[k], radius);
    }
    hn::Store(radius, tag, in_node.radius + part);
    for (int k = 0; k < 3; ++k) {
      const int k1 = (k + 1) % 3;
      const int k2 = (k + 2) % 3;
      const Four cross_radius =
          hn::MulAdd(hn::Set(tag, query.half[k2]), size[k1], hn::Set(tag, padding));
      hn::Store(hn::MulAdd(hn::Set(tag, query.half[k1]), size[k2], cross_radius), tag,
                in_node.cross_radius[k] + part);
    }
    hn::Store(rows.combined(from_origin[0], from_origin[1], from_origin[2]), tag,
              in_node.offset + part);
  }
}

/// What QueryInNode says of one query box, said of the eight boxes of a node, which share their
/// axes: a lane for each.
struct QueriesInNode {
  alignas(16) float axes[3][4];
  alignas(16) float size[3][4];
  alignas(32) float cross_radius[3][3][WideNode::kWidth];
  alignas(32) float offset[3][WideNode::kWidth];
  alignas(32) float radius[3][WideNode::kWidth];
  alignas(32) float half[3][WideNode::kWidth];  ///< with the padding
};

/// `padding` is the slack of the query and the rounding of all that is done here (wide_bounds.h).
HWY_INLINE void set_queries_in_node(QueriesInNode& queries, const WideNode& node,
                                    const WideNode& tested, const TreeTransform& transform,
                                    float padding) {
  const FourTag four;
  float start[3];  // from the origin of the tested node to that of the query boxes' node
  for (int i = 0; i < 3; ++i) {
    const double turned = transform.rotation[i][0] * node.origin[0] +
                          transform.rotation[i][1] * node.origin[1] +
                          transform.rotation[i][2] * node.origin[2];
    start[i] = static_cast<float>((turned * transform.scale + transform.translation[i]) -
                                  tested.origin[i]);
  }
  alignas(16) float axes[3][4];
  for (std::size_t part = 0; part < 4; part += hn::Lanes(four)) {
    const Rows rows(transform.columns, part);
    for (int k = 0; k < 3; ++k) {
      hn::Store(rows.combined(node.axes[0][k], node.axes[1][k], node.axes[2][k]), four,
                axes[k] + part);
    }
  }
  alignas(16) float from_origin[4];
  for (std::size_t part = 0; part < 4; part += hn::Lanes(four)) {
    const Rows rows(tested, part);
    hn::Store(rows.combined(start[0], start[1], start[2]), four, from_origin + part);
    for (int k = 0; k < 3; ++k) {
      const Four in_node = rows.combined(axes[k][0], axes[k][1], axes[k][2]);
      hn::Store(in_node, four, queries.axes[k] + part);
      hn::Store(hn::Abs(in_node), four, queries.size[k] + part);
    }
  }
  const Tag tag;
  const auto scale = hn::Set(tag, static_cast<float>(transform.scale));
  const Lanes margin = hn::Set(tag, padding);
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes half[3], centre[3];
    for (int k = 0; k < 3; ++k) {
      half[k] = hn::Mul(hn::Load(tag, node.half[k] + lane), scale);
      centre[k] = hn::Mul(hn::Load(tag, node.centre[k] + lane), scale);
      hn::Store(hn::Add(half[k], margin), tag, queries.half[k] + lane);
    }
    for (int i = 0; i < 3; ++i) {
      const auto along = [&](int k) HWY_ATTR {
        return hn::Mul(hn::Set(tag, queries.axes[k][i]), centre[k]);
      };
      // Not fused: the order of the walk depends on it.
      const Lanes turned_centre = hn::Add(hn::Add(along(0), along(1)), along(2));
      hn::Store(hn::Add(turned_centre, hn::Set(tag, from_origin[i])), tag,
                queries.offset[i] + lane);
      const auto size = [&](int k) HWY_ATTR { return hn::Set(tag, queries.size[k][i]); };
      const Lanes radius = hn::MulAdd(half[1], size(1), hn::MulAdd(half[0], size(0), margin));
      hn::Store(hn::MulAdd(half[2], size(2), radius), tag, queries.radius[i] + lane);
      for (int k = 0; k < 3; ++k) {
        const int k1 = (k + 1) % 3;
        const int k2 = (k + 2) % 3;
        hn::Store(hn::MulAdd(half[k1], size(k2), hn::MulAdd(half[k2], size(k1), margin)), tag,
                  queries.cross_radius[k][i] + lane);
      }
    }
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
