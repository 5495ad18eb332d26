#include <graze/bvh/build/split.h>
#include <graze/bvh/build/top_split.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/tree/node_lanes.h>
#include <graze/bvh/value/parallel.h>

namespace graze::bvh {
namespace {

/// A part whose node is known.
struct Open {
  std::size_t node;
  Part part;
  SplitResult result = SplitResult::Leaf;
  Part sides[2];
};

}  // namespace

// Parts are split level by level, so that the order in which nodes are made does not depend on what
// tasks do to the parts of a level.
TopTree split_top(std::span<Reference> references, std::size_t part_size,
                  const BuildSettings& settings, int depth) {
  TopTree tree;
  std::vector<Open> level{
      {0, part_of(references, 0, references.size(), depth), SplitResult::Leaf, {}}};
  tree.nodes.push_back(node_over(level[0].part.box, 0, 0));
  while (!level.empty()) {
    for_in_parallel(std::size_t{0}, level.size(), [&](std::size_t i) {
      in_standard_arithmetic([&] {
        Open& open = level[i];
        if (open.part.size() <= part_size) return;
        open.result = split(references, open.part, settings, open.sides);
      });
    });
    std::vector<Open> next;
    for (const Open& open : level) {
      Node& node = tree.nodes[open.node];
      if (open.result == SplitResult::Leaf) {
        node.first = static_cast<std::uint32_t>(tree.parts.size());
        node.count = static_cast<std::uint32_t>(open.part.size());
        tree.parts.push_back(open.part);
        continue;
      }
      node.first = static_cast<std::uint32_t>(tree.nodes.size());
      for (const Part& side : open.sides) {
        next.push_back({tree.nodes.size(), side, SplitResult::Leaf, {}});
        tree.nodes.push_back(node_over(side.box, 0, 0));
      }
    }
    level = std::move(next);
  }
  return tree;
}

}  // namespace graze::bvh
