// The walk over two wide trees of which one goes straight, for each SIMD target that the compiler
// knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/walk/wide_cast_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/walk/cast_lanes-inl.h>
#include <graze/bvh/wide/walk/wide_cast_walk.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// What leaves lie apart at least, when they are nearly full.
inline constexpr std::size_t kLeafBytes = 128;

class Walker {
 public:
  Walker(WideCastWalk::State& state, std::span<CastPlaces> found, float limit,
         WideWalkCounts& counts)
      : state_(state), found_(found), limit_(limit), counts_(counts) {}

  std::size_t run() {
    while (!state_.open.empty() && size_ == 0) {
      const WideCastWalk::Waiting pair = state_.open.pop();
      if (!(pair.bound > limit_)) compare(pair);
    }
    return size_;
  }

 private:
  HWY_INLINE void compare(const WideCastWalk::Waiting& pair) {
    const std::uint32_t link_a = pair.a.node->child[pair.a.lane];
    const std::uint32_t link_b = pair.b.node->child[pair.b.lane];
    if (ChildLink::is_leaf(link_a) && ChildLink::is_leaf(link_b)) {
      compare_leaves({pair.a.treelet, link_a}, {pair.b.treelet, link_b});
      return;
    }
    const bool is_a_opened = is_first_opened(pair.a, link_a, pair.b, link_b, state_.scale_b);
    open_tested(is_a_opened ? 0 : 1, is_a_opened ? pair.a : pair.b, is_a_opened ? link_a : link_b,
                is_a_opened ? pair.b : pair.a, is_a_opened ? link_b : link_a);
  }

  HWY_INLINE void open_tested(int tested_side, const WideChildRef& tested,
                              std::uint32_t tested_link, const WideChildRef& query,
                              std::uint32_t query_link) {
    const WideChildRef below =
        first_below(*state_.tree[tested_side], tested, tested_link, counts_.treelets);
    const WideNode& node = *below.node;
    set_query(1 - tested_side, query, query_link);
    std::uint32_t near =
        node.lanes() & set_cast_bounds(bounds_, boxes(tested_side, below), query_box_, tested_side,
                                       state_.per_normal, limit_);
    counts_.box_tests += node.count;
    counts_.box_rejections += node.count - static_cast<std::uint32_t>(std::popcount(near));
    while (near != 0) {
      const std::uint32_t lane = farthest(near, bounds_);
      near &= ~(1u << lane);
      const WideChildRef child = {&node, lane, below.treelet};
      state_.open.push(
          {tested_side == 0 ? child : query, tested_side == 0 ? query : child, bounds_[lane]});
    }
  }

  HWY_INLINE void set_query(int side, const WideChildRef& query, std::uint32_t link) {
    if (ChildLink::is_leaf(link))
      set_cast_box(query_box_, leaf(side, query.treelet, link), ChildLink::count(link));
    else
      set_cast_box(query_box_, boxes(side, query), query.lane);
  }

  /// Along all axes, of the node that this is a child of.
  HWY_INLINE const AlongNode& boxes(int side, const WideChildRef& child) {
    auto& nodes = state_.nodes[side];
    const std::size_t place = nodes.place_of(child.node, sizeof(WideNode));
    const bool is_kept = nodes.is_of(place, child.node);
    if (is_kept && nodes.is_along(place, state_.normals)) return nodes.at(place);
    AlongNode& anew = nodes.set(place, child.node, state_.normals);
    if (!is_kept) set_aligned_boxes(anew.straight, *child.node, state_.straight[side]);
    set_aligned_boxes(anew.turned, *child.node, state_.turned[side]);
    return anew;
  }

  HWY_INLINE const AlongLeaf& leaf(int side, std::uint32_t index, std::uint32_t link) {
    const WideTree::Treelet& treelet = state_.tree[side]->treelet(index);
    auto& leaves = state_.leaves[side];
    const float* rows = rows_of(treelet, link);
    const std::size_t place = leaves.place_of(rows, kLeafBytes);
    const bool is_kept = leaves.is_of(place, rows);
    if (is_kept && leaves.is_along(place, state_.normals)) return leaves.at(place);
    AlongLeaf& anew = leaves.set(place, rows, state_.normals);
    if (!is_kept) set_aligned_leaf(anew.straight, treelet, link, state_.straight[side]);
    set_aligned_leaf(anew.turned, treelet, link, state_.turned[side]);
    return anew;
  }

  struct Leaf {
    std::uint32_t treelet;
    std::uint32_t link;
  };

  HWY_INLINE void compare_leaves(const Leaf& a, const Leaf& b) {
    const std::uint32_t all = pairs_of(ChildLink::count(a.link), ChildLink::count(b.link));
    counts_.primitive_tests += static_cast<std::uint32_t>(std::popcount(all));
    std::uint32_t pairs =
        all & set_cast_bounds(pair_bounds_, leaf(0, a.treelet, a.link), leaf(1, b.treelet, b.link),
                              state_.per_normal, limit_);
    const std::uint32_t first_a = first_of(0, a), first_b = first_of(1, b);
    for (; pairs != 0; pairs &= pairs - 1) {
      const auto pair = static_cast<std::uint32_t>(std::countr_zero(pairs));
      found_[size_++] = {{first_a + pair / 4, first_b + pair % 4}, pair_bounds_[pair]};
    }
  }

  HWY_INLINE std::uint32_t first_of(int side, const Leaf& leaf) const {
    return state_.tree[side]->treelet(leaf.treelet).first + ChildLink::first(leaf.link);
  }

  WideCastWalk::State& state_;
  std::span<CastPlaces> found_;
  float limit_;
  WideWalkCounts& counts_;
  std::size_t size_ = 0;
  CastBox query_box_;
  alignas(32) float bounds_[WideNode::kWidth];
  alignas(64) float pair_bounds_[kLeafPairs];
};

std::size_t walk(WideCastWalk::State& state, std::span<CastPlaces> found, float limit,
                 WideWalkCounts& counts) {
  return Walker(state, found, limit, counts).run();
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(walk);

std::size_t WideCastWalk::next(std::span<CastPlaces> found, double limit) {
  const float rounded = limit < std::numeric_limits<float>::max()
                            ? rounded_up(limit)
                            : std::numeric_limits<float>::infinity();
  return HWY_DYNAMIC_DISPATCH(walk)(state_, found, rounded, counts_);
}

}  // namespace graze::bvh
#endif
