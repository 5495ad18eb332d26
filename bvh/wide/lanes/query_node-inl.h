// All boxes of a node of one wide tree along the axes of a node of the other. Included once for
// each SIMD target.

#if defined(GRAZE_BVH_QUERY_NODE) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_QUERY_NODE
#undef GRAZE_BVH_QUERY_NODE
#else
#define GRAZE_BVH_QUERY_NODE
#endif

#include <graze/bvh/wide/lanes/query_box-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

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
