#pragma once

#include <graze/bvh/top_split.h>
#include <graze/bvh/wide/wide_tree.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// The nodes above the treelets: the box of everything in node 0, and below it boxes along the
/// coordinate axes, the last of which lead to part i as treelet i + 1.
std::vector<WideNode> top_nodes(const TopTree& top, const FloatBox& box);

/// Builds the nodes and corners of a treelet whose first, count and depth are set. `order` names
/// its primitives, and is put in the order of its leaves. O(n log n).
void build_treelet(WideTree::Treelet& treelet, std::span<std::uint32_t> order,
                   const LocalFrame& frame, const CornerSource& source);

/// How wide trees are split: leaves as large as they may be, for eight boxes or four primitives
/// cost a walk about the same.
inline constexpr BuildSettings kWideSettings = {.max_leaf_size = ChildLink::kMaxLeafSize,
                                                .primitive_cost = 0.1f};

}  // namespace graze::bvh
