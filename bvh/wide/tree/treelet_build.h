#pragma once

#include <graze/bvh/wide/tree/corner_source.h>
#include <graze/bvh/wide/tree/wide_top.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Returns the nodes above the treelets: the box of everything in node 0, and below it boxes along
/// the coordinate axes, the last of which lead to part i as treelet i + 1.
std::vector<WideNode> top_nodes(std::span<const Node> top, const FloatBox& box);

/// Builds a treelet. `order` names the part's primitives, and is put in the order of its leaves. It
/// takes O(n log n).
Treelet built_treelet(const TreeletPart& part, std::span<std::uint32_t> order,
                      const LocalFrame& frame, const CornerSource& source);

}  // namespace graze::bvh
