#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <cstdint>
#include <vector>

namespace graze::bvh {

/// The settings by which wide trees are split: leaves are as large as they may be, for eight boxes
/// or four primitives cost a walk about the same; and nearly as full as they may be, for three cost
/// as much as four, though four large ones meet more.
inline constexpr BuildSettings kWideSettings = {
    .max_leaf_size = ChildLink::kMaxLeafSize, .primitive_cost = 0.1f, .empty_place_cost = 0.5f};

/// Splits all primitives, and fills `order` with them, part by part. It is parallel.
WideTop split_all(const CornerSource& source, const LocalFrame& frame,
                  std::vector<std::uint32_t>& order);

/// Returns the stock's top fitted to where the primitives are now, `order` being the stock's. What
/// has degraded is split anew, with the primitives below it in a new order. It is parallel, and
/// takes linear time but for what is split anew.
WideTop refitted(WideTop stock, const CornerSource& source, const LocalFrame& frame,
                 std::vector<std::uint32_t>& order);

}  // namespace graze::bvh
