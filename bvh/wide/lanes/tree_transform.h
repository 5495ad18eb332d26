#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/tree/wide_tree.h>

namespace graze::bvh {

/// The relative transform of two wide trees: a point p of the frame of the tree that query boxes
/// come from lies at rotation * p * scale + translation in the frame of the tree whose nodes they
/// are tested against, in the local units of that one. Private to bvh/wide.
struct alignas(16) TreeTransform {
  float columns[3][4];  ///< of the rotation, rounded; the fourth component is 0
  float scaled[3][3];   ///< the same columns times the scale
  double rotation[3][3];
  double translation[3];
  double scale;  ///< the unit of the query boxes' tree in that of the tested nodes'
  float slack;   ///< three times the slack of the query (wide_bounds.h)

  /// Tested nodes are those of tree A, query boxes those of tree B.
  explicit TreeTransform(const RelativeFrame& frame);
};

}  // namespace graze::bvh
