#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/tree/wide_tree.h>

namespace graze::bvh {

/// How one wide tree, the query box, lies in another, the tested node, in the tested node's local
/// units: a point p of the query box's frame is at rotation * p * scale + translation. Private to
/// bvh/wide.
struct alignas(16) WideWay {
  float columns[3][4];  // of the rotation, rounded; then 0
  float scaled[3][3];   // the same times the scale
  double rotation[3][3];
  double translation[3];
  double scale;  // of a query box's unit
  float slack;   // three times the query's (wide_bounds.h)

  /// Of frame B, the query box, in frame A.
  explicit WideWay(const RelativeFrame& frame);
};

}  // namespace graze::bvh
