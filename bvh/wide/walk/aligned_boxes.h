#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <array>
#include <cstddef>
#include <functional>

namespace graze::bvh {

/// How a wide tree lies along three axes at right angles that it shares with another tree, in
/// common units: a point p of its frame is at axes * p + offset. Private to bvh/wide.
struct AlignedTransform {
  double axes[3][3];  ///< [axis][component]: as long as the tree's unit
  double offset[3];
  float rows[3][3];  ///< the axes, rounded
  float unit;
  float slack;  ///< of the query, in the transform of one tree only, and room for underflow
};

/// Axes at right angles, the first along a direction; false if that is too short or long to be one.
bool set_axes(double (&axes)[3][3], const double (&direction)[3]);

/// Both trees along axes of length 1, seen from a point, which are in the frame of A.
void align_to(AlignedTransform (&transforms)[2], const RelativeFrame& b_in_a,
              const double (&axes)[3][3], const double (&point)[3]);

/// Both trees along axes of which the first is this direction, seen from a point near what is
/// looked for: floats tell most apart there. Both are in the frame of A, the point in common units.
/// False for a direction that is none.
bool align_along(AlignedTransform (&transforms)[2], const RelativeFrame& b_in_a,
                 const double (&direction)[3], const double (&point)[3]);

/// The children of a node as boxes along such axes: lanes beyond the node's count say nothing.
struct alignas(32) AlignedNode {
  float low[3][WideNode::kWidth];
  float high[3][WideNode::kWidth];
};

/// The primitives of a leaf along such axes, each by itself.
struct alignas(32) AlignedLeaf {
  float low[3][ChildLink::kMaxLeafSize];
  float high[3][ChildLink::kMaxLeafSize];
};

/// Nodes that were aligned: a walk meets the same few again and again. One that has no room left is
/// aligned anew when it is met.
class AlignedNodes {
 public:
  /// Sets aside what there is: only the places are marked, which are apart from the boxes.
  void clear() { nodes_.fill(nullptr); }

  /// Where this node is, or belongs.
  std::size_t place_of(const WideNode* node) const {
    return (std::hash<const WideNode*>()(node) / sizeof(WideNode)) % kRoom;
  }

  const WideNode*& node_at(std::size_t place) { return nodes_[place]; }
  AlignedNode& boxes_at(std::size_t place) { return boxes_[place]; }

 private:
  static constexpr std::size_t kRoom = 128;

  std::array<const WideNode*, kRoom> nodes_;
  std::array<AlignedNode, kRoom> boxes_;
};

}  // namespace graze::bvh
