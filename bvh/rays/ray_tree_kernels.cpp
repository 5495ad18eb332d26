// A ray's walk through a RayTree for each SIMD target that the compiler knows. Bounds are outward
// and what is unsure is handed on, so that targets need not agree in them for answers to agree.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/rays/ray_tree_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/rays/ray_boxes-inl.h>
#include <graze/bvh/rays/ray_leaf-inl.h>
#include <graze/bvh/rays/ray_start-inl.h>
#include <graze/bvh/rays/ray_tree_walk.h>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

HWY_INLINE std::uint32_t take_lane(std::uint32_t& bits) {
  const auto lane = static_cast<std::uint32_t>(std::countr_zero(bits));
  bits &= bits - 1;
  return lane;
}

HWY_INLINE Open opened(std::uint32_t line, std::uint32_t lane, float enter) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(enter)} << 32 | line << 3 | lane;
}
HWY_INLINE float enter_of(Open open) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(open >> 32));
}
HWY_INLINE std::uint32_t line_of(Open open) {
  return static_cast<std::uint32_t>(open) >> 3;
}
HWY_INLINE std::uint32_t lane_of(Open open) {
  return static_cast<std::uint32_t>(open) & 7;
}

/// What will be read first when the child's turn comes.
HWY_INLINE void fetch(const RayTree& tree, const RayNode& node, std::uint32_t lane) {
  if (node.in_leaf[lane] != 0) {
    hwy::Prefetch(node.corners(lane));
  } else {
    hwy::Prefetch(&tree.node(node.child[lane]));
  }
}

/// Puts all of the children but the nearest on the stack, the nearest of them last, and returns
/// that one.
HWY_INLINE Open open_children(const RayTree& tree, const RayNode& node, std::uint32_t line,
                              std::uint32_t lanes, const float* enters, Open*& end) {
  const std::uint32_t one = take_lane(lanes);
  Open nearest = opened(line, one, enters[one]);
  if (lanes == 0) return nearest;
  fetch(tree, node, one);
  Open* const first = end;
  do {
    const std::uint32_t lane = take_lane(lanes);
    fetch(tree, node, lane);
    const Open child = opened(line, lane, enters[lane]);
    const Open farther = HWY_MAX(child, nearest);
    nearest = HWY_MIN(child, nearest);
    Open* at = end++;
    for (; at != first && at[-1] < farther; --at)
      *at = at[-1];
    *at = farther;
  } while (lanes != 0);
  return nearest;
}

/// What of a leaf is not surely missed; how many. Lowers the limit to sure hits, and says whether
/// there were any, unless all are wanted.
HWY_INLINE std::size_t visit_leaf(const RayTree& tree, const RayNode& node,
                                  std::uint32_t lane_of_leaf, RayWalkState& state,
                                  RayCandidate* found, bool& is_surely_hit) {
  const std::uint32_t* const primitives = tree.primitives + node.child[lane_of_leaf];
  hwy::Prefetch(primitives);
  const SeenLeaf seen(node, lane_of_leaf, state);
  alignas(32) float least[RayTree::kLeafSize], most[RayTree::kLeafSize];
  LeafAnswer answer =
      ask_leaf(node.corners(lane_of_leaf), node.in_leaf[lane_of_leaf], seen, state, least, most);
  if (answer.sure != 0 && state.aim != RayAim::All) {
    is_surely_hit = true;
    for (std::uint32_t sure = answer.sure; sure != 0;) {
      const float last = most[take_lane(sure)];
      if (last < state.limit) state.limit = last;
    }
  }
  std::size_t size = 0;
  while (answer.near != 0) {
    const std::uint32_t lane = take_lane(answer.near);
    if (least[lane] > state.limit) continue;
    hwy::Prefetch(state.rows + primitives[lane] * state.row_size);
    found[size++] = {primitives[lane], least[lane], (answer.sure >> lane & 1) != 0};
  }
  return size;
}

std::size_t walk_from_open(const RayTree& tree, RayWalkState& state, std::span<RayCandidate> found,
                           RayWalkCounts& counts) {
  const RayBoxes boxes(state);
  Open* end = state.open + state.open_count;
  std::size_t size = 0;
  std::uint32_t tested = 0, met = 0;
  bool is_surely_hit = false;
  while (end != state.open && size + RayTree::kLeafSize <= found.size()) {
    Open top = *--end;
    if (enter_of(top) > state.limit) continue;
    const RayNode* parent = &tree.node(line_of(top));
    while (parent != nullptr && parent->in_leaf[lane_of(top)] == 0) {
      const std::uint32_t line = parent->child[lane_of(top)];
      const RayNode& node = tree.node(line);
      alignas(32) float enters[RayNode::kWidth];
      const std::uint32_t lanes = boxes.near_children(node, state.limit, enters);
      tested += node.child_count;
      met += static_cast<std::uint32_t>(std::popcount(lanes));
      parent = nullptr;
      if (lanes == 0) break;
      top = open_children(tree, node, line, lanes, enters, end);
      parent = &node;
    }
    if (parent == nullptr) continue;
    counts.primitives += parent->in_leaf[lane_of(top)];
    size += visit_leaf(tree, *parent, lane_of(top), state, found.data() + size, is_surely_hit);
    if (is_surely_hit && state.aim == RayAim::Any) end = state.open;
  }
  counts.boxes += tested;
  counts.missed_boxes += tested - met;
  state.open_count = static_cast<std::uint32_t>(end - state.open);
  return size;
}

/// The beginning of a walk, and all of most.
std::size_t walk_from_root(const RayTree& tree, const RayToWalk& ray, RayWalkState& state,
                           std::span<RayCandidate> found, RayWalkCounts& counts) {
  start_walk(tree, ray, state);
  if (state.open_count == 0) return 0;
  // The root is a child of the node in front of it.
  state.open[0] = opened(0, 0, 0);
  return walk_from_open(tree, state, found, counts);
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(walk_from_root);
HWY_EXPORT(walk_from_open);

std::size_t begin_ray_walk(const RayTree& tree, const RayToWalk& ray, RayWalkState& state,
                           std::span<RayCandidate> found, RayWalkCounts& counts) {
  return HWY_DYNAMIC_DISPATCH(walk_from_root)(tree, ray, state, found, counts);
}

std::size_t walk_ray_tree(const RayTree& tree, RayWalkState& state, std::span<RayCandidate> found,
                          RayWalkCounts& counts) {
  return HWY_DYNAMIC_DISPATCH(walk_from_open)(tree, state, found, counts);
}

}  // namespace graze::bvh
#endif
