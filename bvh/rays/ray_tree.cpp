#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/rays/large_pages.h>
#include <graze/bvh/rays/ray_groups.h>
#include <graze/bvh/rays/ray_leaves.h>
#include <graze/bvh/rays/ray_tree.h>
#include <graze/bvh/value/parallel.h>

#include <algorithm>
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

template <typename Item>
std::unique_ptr<Item[], RayTree::LargePages> in_large_pages(std::size_t count) {
  const std::size_t bytes = count * sizeof(Item);
  void* memory = ::operator new(bytes, kLargePage);
  ask_for_large_pages(memory, bytes);
  return std::unique_ptr<Item[], RayTree::LargePages>(static_cast<Item*>(memory));
}

/// Makes the leaves of a tree whose nodes are made.
void make_leaves(const LeafSource& source, RayTree& rays) {
  const std::size_t count = source.tree.primitives.size();
  const std::size_t taken = rays.node_count * sizeof(RayNode) / sizeof(std::uint32_t);
  const std::size_t most = RayTree::kMostWords * count;
  const std::size_t needed = taken + RayTree::kRoom;
  const auto shared = shared_leaves(source, most > needed ? most - needed : 0);
  rays.leaves = shared ? RayLeaves::SharedPoints : RayLeaves::Corners;
  const std::size_t words = shared ? shared->back() : 3 * count;
  rays.corner_count = words + RayTree::kRoom;
  rays.corners = in_large_pages<std::uint32_t>(rays.corner_count);
  std::fill_n(rays.corners.get() + words, RayTree::kRoom, 0u);
  if (shared) {
    auto place = shared->begin();
    for (std::size_t i = 0; i < rays.node_count; ++i) {
      for (RayChild& child : rays.nodes[i].child) {
        if (child.is_leaf()) child = RayChild::leaf(*place++, child.count());
      }
    }
  }
  for_in_parallel(std::size_t{0}, source.nodes.size(), [&](std::size_t i) {
    in_standard_arithmetic([&] {
      if (shared) {
        fill_shared_points(source, i, rays.nodes[i], rays.corners.get());
      } else {
        fill_corners(source, i, rays.corners.get());
      }
    });
  });
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
  if (count > RayChild::kMostPlaces) return rays;
  const Laid laid = lay_out(tree, RayGroups(tree, RayTree::kLeafSize));
  if (laid.nodes.size() > RayTree::kMostNodes) return rays;
  rays.primitives = tree.primitives.data();
  // Each node on a path down leaves all of its children but one.
  rays.most_open = (RayNode::kWidth - 1) * laid.depth + 1;
  rays.node_count = laid.nodes.size();
  rays.nodes = in_large_pages<RayNode>(rays.node_count);
  std::uninitialized_copy(laid.nodes.begin(), laid.nodes.end(), rays.nodes.get());
  make_leaves({tree, laid.nodes, corners}, rays);
  return rays;
}

}  // namespace graze::bvh
