// A ray's walk through a RayTree is compiled for each SIMD target that the compiler knows. Bounds
// are outward and what is unsure is handed on, so that targets need not agree in them for answers
// to agree.

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

HWY_INLINE std::uint32_t first_lane(std::uint32_t bits) {
  return static_cast<std::uint32_t>(std::countr_zero(bits));
}

HWY_INLINE std::uint32_t take_lane(std::uint32_t& bits) {
  const std::uint32_t lane = first_lane(bits);
  bits &= bits - 1;
  return lane;
}

HWY_INLINE Open opened(std::uint32_t where, std::uint32_t lane, float enter) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(enter)} << 32 | where << 3 | lane;
}
HWY_INLINE float enter_of(Open open) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(open >> 32));
}
HWY_INLINE std::uint32_t node_of(Open open) {
  return static_cast<std::uint32_t>(open) >> 3;
}
HWY_INLINE std::uint32_t lane_of(Open open) {
  return static_cast<std::uint32_t>(open) & 7;
}

/// Fetches what is read when a child's turn comes. There is no branch, as leaves and nodes come in
/// no order that could be foretold. Addresses are integers: those behind the last leaf are fetched,
/// but are of no object.
HWY_INLINE void prefetch(const RayTree& tree, RayChild child) {
  constexpr std::size_t kLine = 64;
  const std::size_t leaf = sizeof(std::uint32_t) * tree.first_word(child);
  const std::size_t node = RayTree::kUnit * std::size_t{child.where()};
  const auto first = child.is_leaf() ? reinterpret_cast<std::uintptr_t>(tree.corners.get()) + leaf
                                     : reinterpret_cast<std::uintptr_t>(tree.nodes.get()) + node;
  // Of leaves that share points the places of the primitives are not known yet.
  const auto last = child.is_leaf() && tree.leaves == RayLeaves::Corners
                        ? reinterpret_cast<std::uintptr_t>(tree.primitives + child.place())
                        : first + 3 * kLine;
  for (const std::uintptr_t line : {first, first + kLine, first + 2 * kLine, last})
    hwy::Prefetch(reinterpret_cast<const std::byte*>(line));
}

/// Puts all of the children but the nearest on the stack, the nearest of them last, and returns
/// that one. There are at least two.
HWY_INLINE Open open_children(const RayTree& tree, const RayNode& node, std::uint32_t where,
                              std::uint32_t lanes, const float* enters, Open*& end) {
  const std::uint32_t a = take_lane(lanes), b = take_lane(lanes);
  prefetch(tree, node.child[a]);
  prefetch(tree, node.child[b]);
  const Open first = opened(where, a, enters[a]), second = opened(where, b, enters[b]);
  Open nearest = HWY_MIN(first, second);
  Open* const bottom = end;
  *end++ = HWY_MAX(first, second);
  while (lanes != 0) {
    const std::uint32_t lane = take_lane(lanes);
    prefetch(tree, node.child[lane]);
    const Open child = opened(where, lane, enters[lane]);
    const Open farther = HWY_MAX(child, nearest);
    nearest = HWY_MIN(child, nearest);
    Open* at = end++;
    for (; at != bottom && at[-1] < farther; --at)
      *at = at[-1];
    *at = farther;
  }
  return nearest;
}

/// A leaf that a ray has been compared with.
struct AskedLeaf {
  const std::uint32_t* primitives;
  LeafAnswer answer;
  alignas(32) float least[RayTree::kLeafSize];
  float most[RayTree::kLeafSize];
};

HWY_INLINE void ask_corners(const RayTree& tree, RayChild leaf, const SeenLeaf& seen,
                            const RayWalkState& state, AskedLeaf& asked) {
  asked.primitives = tree.primitives + leaf.place();
  // A row of indices and its points are two misses, one after the other: the first begins before it
  // is known whose row counts.
  const PrimitivePoints& ahead = state.primitives;
  if (ahead.points != nullptr) {
    for (std::uint32_t i = 0; i < leaf.count(); ++i)
      hwy::Prefetch(ahead.indices + asked.primitives[i]);
  } else {
    hwy::Prefetch(asked.primitives);
  }
  asked.answer = ask_leaf(tree.leaf(leaf), leaf.count(), seen, state, asked.least, asked.most);
}

HWY_INLINE void ask_shared_points(const RayTree& tree, RayChild leaf, const SeenLeaf& seen,
                                  const RayWalkState& state, AskedLeaf& asked) {
  const auto& shared = *reinterpret_cast<const SharedPoints*>(tree.leaf(leaf));
  const std::uint32_t* const points = tree.leaf(leaf) + SharedPoints::kHeader;
  asked.primitives = tree.primitives + shared.place();
  hwy::Prefetch(asked.primitives);
  if (const double* const ahead = state.primitives.points; ahead != nullptr) {
    // Most leaves have about as many points as this. There is no branch: after the last one comes
    // the last one again.
    constexpr std::uint32_t kFetched = 8;
    const std::uint32_t last = shared.count() - 1;
    const std::uint32_t* const numbers = points + shared.count();
    for (std::uint32_t i = 0; i < kFetched; ++i)
      hwy::Prefetch(ahead + std::size_t{3} * numbers[HWY_MIN(i, last)]);
  }
  asked.answer = ask_leaf(shared, points, leaf.count(), seen, state, asked.least, asked.most);
}

/// Returns a candidate, and begins to fetch its numbers.
HWY_INLINE RayCandidate candidate_of(const RayTree& tree, RayChild leaf, const AskedLeaf& asked,
                                     std::uint32_t lane, const PrimitivePoints& ahead) {
  RayCandidate candidate;
  candidate.primitive = asked.primitives[lane];
  candidate.least = asked.least[lane];
  candidate.is_sure = (asked.answer.sure >> lane & 1) != 0;
  if (tree.leaves == RayLeaves::SharedPoints) {
    const auto& shared = *reinterpret_cast<const SharedPoints*>(tree.leaf(leaf));
    const std::uint32_t* const numbers = tree.leaf(leaf) + SharedPoints::kHeader + shared.count();
    for (std::uint32_t c = 0; c < 3; ++c)
      candidate.corners[c] = numbers[shared.corner(lane, c)];
  } else if (ahead.points != nullptr) {
    candidate.corners = ahead.indices[candidate.primitive];
  } else {
    hwy::Prefetch(ahead.indices + candidate.primitive);
    candidate.corners = {};
    return candidate;
  }
  if (ahead.points != nullptr) {
    for (const std::uint32_t point : candidate.corners)
      hwy::Prefetch(ahead.points + std::size_t{3} * point);
  }
  return candidate;
}

/// Lists the primitives of a leaf that are not surely missed, and returns how many. Lowers the
/// limit to sure hits, and says whether there were any, unless all are wanted. It is no part of the
/// loop over nodes, which would leave it half of the registers.
HWY_NOINLINE std::size_t visit_leaf(const RayTree& tree, const RayNode& node, std::uint32_t of_leaf,
                                    RayWalkState& state, RayCandidate* found, bool& is_surely_hit) {
  const RayChild leaf = node.child[of_leaf];
  const SeenLeaf seen(node, of_leaf, state);
  AskedLeaf asked;
  if (tree.leaves == RayLeaves::SharedPoints) {
    ask_shared_points(tree, leaf, seen, state, asked);
  } else {
    ask_corners(tree, leaf, seen, state, asked);
  }
  if (asked.answer.sure != 0 && state.aim != RayAim::All) {
    is_surely_hit = true;
    for (std::uint32_t sure = asked.answer.sure; sure != 0;) {
      const float last = asked.most[take_lane(sure)];
      if (last < state.limit) state.limit = last;
    }
  }
  std::size_t size = 0;
  for (std::uint32_t near = asked.answer.near; near != 0;) {
    const std::uint32_t lane = take_lane(near);
    if (asked.least[lane] <= state.limit)
      found[size++] = candidate_of(tree, leaf, asked, lane, state.primitives);
  }
  return size;
}

HWY_INLINE std::size_t walk(const RayTree& tree, RayWalkState& state, Open* end) {
  const RayBoxes boxes(state);
  const std::span<RayCandidate> found = state.found;
  std::size_t size = 0;
  std::uint32_t tested = 0, met = 0, primitives = 0;
  bool is_surely_hit = false;
  while (end != state.open && size + RayTree::kLeafSize <= found.size()) {
    const Open top = *--end;
    if (enter_of(top) > state.limit) continue;
    const RayNode* node = &tree.node(node_of(top));
    std::uint32_t lane = lane_of(top);
    RayChild child = node->child[lane];
    std::uint32_t lanes = 1;
    while (!child.is_leaf()) {
      node = &tree.node(child.where());
      alignas(32) float enters[RayNode::kWidth];
      lanes = boxes.near_children(*node, state.limit, enters);
      ++tested;
      if (lanes == 0) break;
      met += static_cast<std::uint32_t>(std::popcount(lanes));
      if ((lanes & (lanes - 1)) == 0) {
        // If there is only one, the next node does not wait for where the ray enters it.
        lane = first_lane(lanes);
      } else {
        lane = lane_of(open_children(tree, *node, child.where(), lanes, enters, end));
      }
      child = node->child[lane];
    }
    if (lanes == 0) continue;
    primitives += child.count();
    size += visit_leaf(tree, *node, lane, state, found.data() + size, is_surely_hit);
    if (is_surely_hit && state.aim == RayAim::Any) end = state.open;
  }
  state.counts = {RayNode::kWidth * tested, RayNode::kWidth * tested - met, primitives};
  state.open_count = static_cast<std::uint32_t>(end - state.open);
  return size;
}

std::size_t walk_from_open(const RayTree& tree, RayWalkState& state) {
  return walk(tree, state, state.open + state.open_count);
}

/// Begins a walk; for most rays this is all of it.
std::size_t walk_from_root(const RayTree& tree, const RayToWalk& ray, RayWalkState& state) {
  start_walk(tree, ray, state);
  if (state.open_count == 0) return 0;
  // The root is a child of the node in front of it.
  state.open[0] = opened(0, 0, 0);
  return walk(tree, state, state.open + 1);
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(walk_from_root);
HWY_EXPORT(walk_from_open);

std::size_t begin_ray_walk(const RayTree& tree, const RayToWalk& ray, RayWalkState& state) {
  return HWY_DYNAMIC_DISPATCH(walk_from_root)(tree, ray, state);
}

std::size_t walk_ray_tree(const RayTree& tree, RayWalkState& state) {
  return HWY_DYNAMIC_DISPATCH(walk_from_open)(tree, state);
}

}  // namespace graze::bvh
#endif
