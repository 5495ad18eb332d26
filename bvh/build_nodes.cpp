#include <graze/bvh/build_nodes.h>
#include <graze/bvh/subtree.h>
#include <graze/bvh/top_split.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace graze::bvh {
namespace {

/// Below this many primitives a subtree is built by one task, in one core's cache.
constexpr std::size_t kPartSize = 4096;

using Nodes = std::vector<Node>;

/// The nodes of the top with those of the parts below it, depth first, the children of a node side
/// by side behind it: the order that build_subtree() would give all of it.
class Joined {
 public:
  Joined(const TopTree& top, std::vector<Nodes>& subtrees) : top_(top), subtrees_(subtrees) {
    std::size_t count = top.nodes.size() - top.parts.size();
    for (const Nodes& subtree : subtrees)
      count += subtree.size();
    nodes_.reserve(count);
    nodes_.push_back(top.nodes[0]);
    join(0, top.nodes[0]);
  }

  Nodes take() { return std::move(nodes_); }

 private:
  void join(std::size_t at, const Node& node) {
    if (node.is_leaf()) {
      append(at, node.first);
      return;
    }
    const std::size_t children = nodes_.size();
    nodes_[at].first = static_cast<std::uint32_t>(children);
    nodes_.push_back(top_.nodes[node.first]);
    nodes_.push_back(top_.nodes[node.first + 1]);
    join(children, top_.nodes[node.first]);
    join(children + 1, top_.nodes[node.first + 1]);
  }

  /// Puts the root of a subtree where its node of the top is, and the others at the end.
  void append(std::size_t at, std::size_t part) {
    Nodes& subtree = subtrees_[part];
    const auto first_primitive = static_cast<std::uint32_t>(top_.parts[part].begin);
    const auto first_node = static_cast<std::uint32_t>(nodes_.size() - 1);
    for (Node& node : subtree)
      node.first += node.is_leaf() ? first_primitive : first_node;
    nodes_[at] = subtree[0];
    nodes_.insert(nodes_.end(), subtree.begin() + 1, subtree.end());
    Nodes().swap(subtree);
  }

  const TopTree& top_;
  std::vector<Nodes>& subtrees_;
  Nodes nodes_;
};

}  // namespace

std::vector<Node> build_nodes(References references, int depth, const BuildSettings& settings,
                              std::span<std::uint32_t> primitives) {
  const std::span<Reference> all = references.all();
  const TopTree top = split_top(all, kPartSize, settings, depth);
  std::vector<Nodes> subtrees(top.parts.size());
  tbb::parallel_for(std::size_t{0}, top.parts.size(), [&](std::size_t i) {
    const Part& part = top.parts[i];
    subtrees[i] = build_subtree(all, part, settings);
    for (std::size_t k = part.begin; k < part.end; ++k)
      primitives[k] = all[k].index();
  });
  references = {};
  return Joined(top, subtrees).take();
}

}  // namespace graze::bvh
