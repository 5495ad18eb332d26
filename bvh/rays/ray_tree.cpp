#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/rays/large_pages.h>
#include <graze/bvh/rays/ray_groups.h>
#include <graze/bvh/rays/ray_tree.h>
#include <graze/bvh/value/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <vector>

namespace graze::bvh {
namespace {

RayNode empty_node() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const RayChild none = RayChild::node(0);
  RayNode node{{}, {none, none, none, none, none, none, none, none}};
  for (std::size_t row = 0; row < 6; ++row)
    std::fill_n(node.box[row], RayNode::kWidth, row % 2 == 0 ? kInfinity : -kInfinity);
  return node;
}

/// Returns a wide node whose children's places are not known yet.
RayNode node_over(const Tree& tree, const RayGroups& groups,
                  const std::uint32_t (&children)[RayNode::kWidth], std::uint32_t count) {
  RayNode node = empty_node();
  for (std::uint32_t lane = 0; lane < count; ++lane) {
    const FloatBox& box = tree.nodes[children[lane]].box;
    for (std::size_t k = 0; k < 3; ++k) {
      node.box[2 * k][lane] = box.min[k];
      node.box[2 * k + 1][lane] = box.max[k];
    }
    if (groups.is_leaf(children[lane]))
      node.child[lane] = RayChild::leaf(groups.first(children[lane]), groups.count(children[lane]));
  }
  return node;
}

/// The nodes in the order in which they are laid out, each before what is below it.
struct Laid {
  std::vector<RayNode> nodes;
  std::uint32_t depth = 0;
};

Laid lay_out(const Tree& tree, const RayGroups& groups) {
  struct Waiting {
    std::uint32_t binary;
    std::size_t parent;
    std::uint32_t lane;
    std::uint32_t depth;
  };
  Laid laid;
  laid.nodes.push_back(empty_node());
  std::vector<Waiting> waiting{{0, 0, 0, 1}};
  while (!waiting.empty()) {
    const Waiting at = waiting.back();
    waiting.pop_back();
    laid.depth = std::max(laid.depth, at.depth);
    std::uint32_t children[RayNode::kWidth];
    const std::uint32_t count = groups.children(at.binary, children);
    const std::size_t index = laid.nodes.size();
    laid.nodes[at.parent].child[at.lane] = RayChild::node(RayTree::where(index));
    laid.nodes.push_back(node_over(tree, groups, children, count));
    for (std::uint32_t lane = count; lane-- > 0;) {
      if (!groups.is_leaf(children[lane]))
        waiting.push_back({children[lane], index, lane, at.depth + 1});
    }
  }
  return laid;
}

/// Puts the corners of the leaf in lane `lane` on its grid.
void fill_leaf(const RayNode& node, std::uint32_t lane, const Tree& tree,
               const LocalCorners& corners, std::uint32_t* to) {
  double low[3], per_unit[3];
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = node.box[2 * k][lane];
    const double extent = node.box[2 * k + 1][lane] - low[k];
    per_unit[k] = extent > 0 ? RayTree::kSteps / extent : 0;
  }
  const RayChild leaf = node.child[lane];
  const std::uint32_t count = leaf.count();
  to += std::size_t{3} * leaf.place();
  for (std::uint32_t i = 0; i < count; ++i) {
    double corner[3][3];
    corners.of(tree.primitives[leaf.place() + i], corner);
    for (std::uint32_t c = 0; c < 3; ++c) {
      std::uint32_t packed = 0;
      for (int k = 2; k >= 0; --k) {
        const double at = std::nearbyint((corner[c][k] - low[k]) * per_unit[k]);
        const double kept = std::clamp(at, 0.0, static_cast<double>(RayTree::kSteps));
        packed = packed << RayTree::kBits | static_cast<std::uint32_t>(kept);
      }
      to[c * count + i] = packed;
    }
  }
}

void fill_leaves(const RayNode& node, const Tree& tree, const LocalCorners& corners,
                 std::uint32_t* to) {
  for (std::uint32_t lane = 0; lane < RayNode::kWidth; ++lane) {
    if (node.child[lane].is_leaf()) fill_leaf(node, lane, tree, corners, to);
  }
}

template <typename Item>
std::unique_ptr<Item[], RayTree::LargePages> in_large_pages(std::size_t count) {
  const std::size_t bytes = count * sizeof(Item);
  void* memory = ::operator new(bytes, kLargePage);
  ask_for_large_pages(memory, bytes);
  return std::unique_ptr<Item[], RayTree::LargePages>(static_cast<Item*>(memory));
}

}  // namespace

void RayTree::LargePages::operator()(void* made) const {
  ::operator delete(made, kLargePage);
}

RayTree ray_tree_over(const Tree& tree, const LocalCorners& corners) {
  RayTree rays{};
  rays.frame = tree.frame;
  for (std::size_t k = 0; k < 3; ++k) {
    rays.low[k] = tree.root().box.min[k];
    rays.high[k] = tree.root().box.max[k];
  }
  const std::size_t count = tree.primitives.size();
  if (count > std::size_t{1} << RayChild::kPlaceBits) return rays;
  const Laid laid = lay_out(tree, RayGroups(tree, RayTree::kLeafSize));
  if (laid.nodes.size() > RayTree::kMostNodes) return rays;
  rays.primitives = tree.primitives.data();
  // Each node on a path down leaves all of its children but one.
  rays.most_open = (RayNode::kWidth - 1) * laid.depth + 1;
  rays.node_count = laid.nodes.size();
  rays.nodes = in_large_pages<RayNode>(rays.node_count);
  std::uninitialized_copy(laid.nodes.begin(), laid.nodes.end(), rays.nodes.get());
  rays.corner_count = 3 * count + RayTree::kLeafSize;
  rays.corners = in_large_pages<std::uint32_t>(rays.corner_count);
  std::fill_n(rays.corners.get() + 3 * count, RayTree::kLeafSize, 0u);
  for_in_parallel(std::size_t{0}, laid.nodes.size(), [&](std::size_t i) {
    in_standard_arithmetic([&] { fill_leaves(laid.nodes[i], tree, corners, rays.corners.get()); });
  });
  return rays;
}

}  // namespace graze::bvh
