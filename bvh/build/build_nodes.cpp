#include <graze/bvh/build/build_nodes.h>
#include <graze/bvh/build/subtree.h>
#include <graze/bvh/build/top_split.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/tree/graft.h>
#include <graze/bvh/value/parallel.h>

#include <utility>

namespace graze::bvh {
namespace {

/// Below this many primitives a subtree is built by one task, in one core's cache.
constexpr std::size_t kPartSize = 4096;

}  // namespace

std::vector<Node> build_nodes(References references, int depth, const BuildSettings& settings,
                              std::span<std::uint32_t> primitives) {
  const std::span<Reference> all = references.all();
  const TopTree top = split_top(all, kPartSize, settings, depth);
  std::vector<Graft> subtrees(top.parts.size());
  for (std::size_t i = 0; i < top.nodes.size(); ++i) {
    if (top.nodes[i].is_leaf()) subtrees[top.nodes[i].first].at = i;
  }
  for_in_parallel(std::size_t{0}, top.parts.size(), [&](std::size_t i) {
    in_standard_arithmetic([&] {
      const Part& part = top.parts[i];
      subtrees[i].nodes = build_subtree(all, part, settings);
      subtrees[i].first_primitive = static_cast<std::uint32_t>(part.begin);
      for (std::size_t k = part.begin; k < part.end; ++k)
        primitives[k] = all[k].index();
    });
  });
  references = {};
  return std::move(grafted(top.nodes, std::move(subtrees)).nodes);
}

}  // namespace graze::bvh
