#pragma once

#include <graze/bvh/box_separation.h>
#include <limits>

namespace graze::bvh {

/// What a pair of boxes says about the distance between what they hold, in common units.
struct BoxGap {
  double squared_lower_bound;  ///< never NaN
  double squared_between_centres;
};

/// Lower bounds of the distance between node boxes of two trees, in the frame that BoxSeparation
/// uses. One rotation serves the whole query.
class BoxDistance {
 public:
  explicit BoxDistance(const RelativeFrame& frame);

  /// Takes one more direction into account, in the frame of A, from A to B: that in which the best
  /// answer so far lies is the one that separates its neighbours best. Its length is 1 but for
  /// rounding, or 0.
  void set_direction(const double (&direction)[3]);

  /// A bound above this is as good as a larger one.
  void set_limit(double squared_limit) { limit_ = squared_limit; }

  /// The bound is at most the square of the distance if distances are measured along the axes of
  /// `frame` as if they were those of rotations: the caller corrects for the poses' deviation. The
  /// frame's slack is taken off first.
  BoxGap gap(const FloatBox& a, const FloatBox& b) const;

 private:
  RelativeFrame frame_;
  double size_[3][3];  // |rotation|
  double limit_ = std::numeric_limits<double>::infinity();
  double direction_[3] = {0, 0, 0};
  double size_in_a_[3] = {0, 0, 0};  // |direction| along the axes of A
  double size_in_b_[3] = {0, 0, 0};
};

}  // namespace graze::bvh
