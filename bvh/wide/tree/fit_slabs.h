#pragma once

// These set the slabs of a node whose axes and boxes are set. They are private to bvh/wide.

#include <graze/bvh/wide/tree/fit_node.h>
#include <graze/bvh/wide/tree/node_axes.h>

#include <cstdint>
#include <span>

namespace graze::bvh {

/// Sets slopes such that each slab stands across the mean normal of what its child holds, and the
/// slabs. Rows are coordinates less what `origin`, the node's, is given in.
void fit_slabs(const CornerRows& rows, const MomentSums& sums, const NodeAxes& axes,
               const float* origin, std::span<const PrimitiveRange> children, WideNode& node);

/// Does the same with the slopes that the node has.
void refit_slabs(const CornerRows& rows, const NodeAxes& axes, const float* origin,
                 std::span<const PrimitiveRange> children, WideNode& node);

/// Says in all nodes of a treelet whether its slabs are so much thinner than its boxes that it pays
/// to ask them: in all alike, for walks cannot predict what changes from node to node.
void choose_slabs(std::span<WideNode> nodes);

/// Sets a slab that says no more than the box.
void clear_slab(WideNode& node, std::uint32_t lane);

}  // namespace graze::bvh
