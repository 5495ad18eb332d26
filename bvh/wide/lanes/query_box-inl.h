// A box of one wide tree along the axes of a node of the other. Included once for each SIMD target.

#if defined(GRAZE_BVH_GUEST_BOX) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_GUEST_BOX
#undef GRAZE_BVH_GUEST_BOX
#else
#define GRAZE_BVH_GUEST_BOX
#endif

#include <graze/bvh/wide/lanes/wide_way.h>
#include <graze/bvh/wide/tree/wide_bounds.h>
#include <hwy/highway.h>
#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, WideNode::kWidth>;
using Lanes = hn::Vec<Tag>;

// Four values at a time, of which three count, or one by one where there are no vectors.
using FourTag = hn::CappedTag<float, 4>;
using Four = hn::Vec<FourTag>;

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

HWY_INLINE float size_of(const WideChildRef& slot) {
  const WideNode& node = *slot.node;
  return node.half[0][slot.lane] + node.half[1][slot.lane] + node.half[2][slot.lane];
}

/// A box of one tree, in the frame of the other.
struct alignas(16) Query {
  float axes[3][4];  // [axis][component]
  float half[3];
  double middle[3];
};

/// The same along the axes of a tested node, where not said otherwise one value for each of these.
struct alignas(16) QueryInNode {
  float axes[3][4];     // of each query box's axis
  float size[3][4];     // their absolute values
  float crossed[3][4];  // how far it reaches along the cross products with each query box's axis
  float way[4];         // from the node's origin to the middle
  float reach[4];       // along the node's axes
  float half[3];        // along its own, with the slack
  float padding;        // which pays for the slack and the rounding of all this
};

/// What the tests of a tested node's children read of it.
struct OneQuery {
  const QueryInNode& in_node;

  HWY_INLINE float axis(int k, int i) const { return in_node.axes[k][i]; }
  HWY_INLINE float size(int k, int i) const { return in_node.size[k][i]; }
  HWY_INLINE float crossed(int k, int i) const { return in_node.crossed[k][i]; }
  HWY_INLINE float way(int i) const { return in_node.way[i]; }
  HWY_INLINE float reach(int i) const { return in_node.reach[i]; }
  HWY_INLINE float half(int k) const { return in_node.half[k]; }
};

HWY_INLINE void set_query(Query& query, const WideNode& node, std::uint32_t lane,
                          const WideWay& way) {
  const double c[3] = {node.centre[0][lane], node.centre[1][lane], node.centre[2][lane]};
  double middle[3];
  for (int i = 0; i < 3; ++i) {
    middle[i] =
        node.origin[i] + (node.axes[i][0] * c[0] + node.axes[i][1] * c[1] + node.axes[i][2] * c[2]);
  }
  for (int i = 0; i < 3; ++i) {
    query.middle[i] = (way.rotation[i][0] * middle[0] + way.rotation[i][1] * middle[1] +
                       way.rotation[i][2] * middle[2]) *
                          way.scale +
                      way.translation[i];
    query.half[i] = node.half[i][lane] * static_cast<float>(way.scale);
  }
  for (std::size_t part = 0; part < 4; part += hn::Lanes(FourTag())) {
    const Rows rows(way.columns, part);
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
    Four reach = hn::Set(tag, padding);
    for (int k = 0; k < 3; ++k) {
      const Four axis = rows.combined(query.axes[k][0], query.axes[k][1], query.axes[k][2]);
      size[k] = hn::Abs(axis);
      hn::Store(axis, tag, in_node.axes[k] + part);
      hn::Store(size[k], tag, in_node.size[k] + part);
      reach = hn::MulAdd(hn::Set(tag, query.half[k]), size[k], reach);
    }
    hn::Store(reach, tag, in_node.reach + part);
    for (int k = 0; k < 3; ++k) {
      const int k1 = (k + 1) % 3;
      const int k2 = (k + 2) % 3;
      const Four crossed =
          hn::MulAdd(hn::Set(tag, query.half[k2]), size[k1], hn::Set(tag, padding));
      hn::Store(hn::MulAdd(hn::Set(tag, query.half[k1]), size[k2], crossed), tag,
                in_node.crossed[k] + part);
    }
    hn::Store(rows.combined(from_origin[0], from_origin[1], from_origin[2]), tag,
              in_node.way + part);
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
