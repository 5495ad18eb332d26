#pragma once

#include <graze/bvh/box_separation.h>

namespace graze::bvh {

/// Lower bounds of the distance between node boxes of two trees, in the frame that BoxSeparation
/// uses. One rotation serves the whole query.
class BoxDistance {
 public:
  explicit BoxDistance(const RelativeFrame& frame);

  /// At most the square of the distance between what the boxes hold, in common units, if distances
  /// are measured along the axes of `frame` as if they were those of rotations: the caller corrects
  /// for the poses' deviation. The frame's slack is taken off each component first. Never NaN.
  double squared_lower_bound(const FloatBox& a, const FloatBox& b) const;

 private:
  RelativeFrame frame_;
  double size_[3][3];  // |rotation|
};

}  // namespace graze::bvh
