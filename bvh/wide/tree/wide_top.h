#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/tree/tree.h>
#include <graze/bvh/wide/tree/corner_source.h>
#include <graze/bvh/wide/tree/treelet.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace graze::bvh {

/// How wide trees are split: leaves as large as they may be, for eight boxes or four primitives
/// cost a walk about the same; and nearly as full, for three cost as much as four, though four
/// large ones meet more.
inline constexpr BuildSettings kWideSettings = {
    .max_leaf_size = ChildLink::kMaxLeafSize, .primitive_cost = 0.1f, .empty_place_cost = 0.5f};

/// The binary nodes above the treelets. A leaf among them is a treelet: its `first` counts parts,
/// its `count` primitives.
struct WideTop {
  std::vector<Node> nodes;
  std::vector<float> costs;  ///< subtree_costs() when each node was built
  std::vector<TreeletPart> parts;
  // Of each part what an earlier tree made of the same primitives in the same order, if anything.
  std::vector<std::shared_ptr<const Treelet>> inherited;
};

/// What is left of a wide tree for the next one over the same primitives, elsewhere.
struct WideStock {
  WideTop top;
  std::vector<std::uint32_t> primitives;
};

/// Splits all primitives, and fills `order` with them, part by part. Parallel.
WideTop split_all(const CornerSource& source, const LocalFrame& frame,
                  std::vector<std::uint32_t>& order);

/// The stock's top fitted to where the primitives are now, `order` being the stock's. What has
/// degraded is split anew, with the primitives below it in a new order. Parallel; linear time but
/// for what is split anew.
WideTop refitted(WideTop stock, const CornerSource& source, const LocalFrame& frame,
                 std::vector<std::uint32_t>& order);

}  // namespace graze::bvh
