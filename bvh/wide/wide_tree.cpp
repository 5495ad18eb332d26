#include <graze/bvh/build.h>
#include <graze/bvh/wide/collapse.h>
#include <graze/bvh/wide/fit_node.h>
#include <graze/bvh/wide/wide_bounds.h>
#include <graze/bvh/wide/wide_tree.h>

#include <algorithm>
#include <numeric>

namespace graze::bvh {
namespace {

// Eight boxes or four primitives cost a walk about the same: leaves are as large as they may be.
constexpr float kPrimitiveCost = 0.1f;

WideNode whole_tree(const FloatBox& box) {
  WideNode node{};
  node.count = 1;
  for (int k = 0; k < 3; ++k) {
    node.axes[k][k] = 1;
    node.centre[k][0] = 0.5f * (box.min[k] + box.max[k]);
    node.half[k][0] = rounded_up(0.5 * box.max[k] - 0.5 * box.min[k] + 8 * kFitError);
  }
  node.child[0] = ChildLink::to_treelet(1);
  return node;
}

/// The corners leaf by leaf, with room for reading whole vectors at the end.
std::vector<float> leaf_blocks(std::span<const WideTopologyNode> nodes, const CornerRows& rows) {
  std::vector<float> blocks(CornerRows::kRows * rows.size() + 8);
  for (const WideTopologyNode& node : nodes) {
    for (std::uint32_t j = 0; j < node.count; ++j) {
      if (!ChildLink::is_leaf(node.child[j])) continue;
      const PrimitiveRange range = node.range[j];
      float* block = blocks.data() + CornerRows::kRows * range.begin;
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k)
          block = std::copy(rows.row(c, k) + range.begin, rows.row(c, k) + range.end, block);
      }
    }
  }
  return blocks;
}

}  // namespace

WideTree::WideTree(const Aabb& bounds, std::size_t primitives, const CornerSource& source)
    : frame_(LocalFrame::around(bounds)),
      box_(frame_.to_local(bounds)),
      source_(source),
      primitives_(primitives) {
  std::iota(primitives_.begin(), primitives_.end(), 0u);
  treelet_count_ = 2;
  treelets_ = std::make_unique<LazyTreelet[]>(treelet_count_);
  treelets_[0].treelet.nodes.push_back(whole_tree(box_));
  treelets_[0].is_built = true;
  treelets_[1].treelet.first = 0;
  treelets_[1].treelet.count = static_cast<std::uint32_t>(primitives);
}

void WideTree::build(std::uint32_t index) const {
  const LazyTreelet& lazy = treelets_[index];
  std::call_once(lazy.flag, [&] {
    build_nodes(lazy.treelet);
    lazy.is_built.store(true, std::memory_order_release);
  });
}

void WideTree::build_nodes(Treelet& treelet) const {
  const std::span<std::uint32_t> order =
      std::span(primitives_).subspan(treelet.first, treelet.count);
  CornerRows rows(treelet.count);
  source_.fill(order, frame_, treelet.origin, rows);
  std::vector<Aabb> boxes(treelet.count);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = rows.row(0, k)[i], b = rows.row(1, k)[i], c = rows.row(2, k)[i];
      boxes[i].min.data()[k] = std::min(std::min(a, b), c);
      boxes[i].max.data()[k] = std::max(std::max(a, b), c);
    }
  }
  const Tree tree = bvh::build(
      boxes, {.max_leaf_size = ChildLink::kMaxLeafSize, .primitive_cost = kPrimitiveCost});
  std::vector<std::uint32_t> sorted(order.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
    sorted[i] = order[tree.primitives[i]];
  std::copy(sorted.begin(), sorted.end(), order.begin());
  const CornerRows ordered = rows.reordered(tree.primitives);
  treelet.reach = ordered.reach();
  const MomentSums sums(ordered);
  const std::vector<WideTopologyNode> topology = collapse(tree.nodes);
  treelet.nodes.resize(topology.size());
  for (std::size_t i = 0; i < topology.size(); ++i) {
    std::copy_n(topology[i].child, WideNode::kWidth, treelet.nodes[i].child);
    fit_node(ordered, sums, {topology[i].range, topology[i].count}, treelet.nodes[i]);
  }
  treelet.corners = leaf_blocks(topology, ordered);
}

std::size_t WideTree::built_treelets() const {
  std::size_t built = 0;
  for (std::size_t i = 0; i < treelet_count_; ++i)
    built += treelets_[i].is_built.load(std::memory_order_acquire);
  return built;
}

std::size_t WideTree::bytes() const {
  std::size_t bytes = primitives_.size() * sizeof(std::uint32_t);
  for (std::size_t i = 0; i < treelet_count_; ++i) {
    bytes += sizeof(LazyTreelet);
    if (treelets_[i].is_built.load(std::memory_order_acquire))
      bytes += treelets_[i].treelet.nodes.size() * sizeof(WideNode) +
               treelets_[i].treelet.corners.size() * sizeof(float);
  }
  return bytes;
}

}  // namespace graze::bvh
