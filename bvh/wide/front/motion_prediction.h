#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/front/front_planes.h>
#include <graze/bvh/wide/tree/wide_tree.h>

// What a motion does next is mostly what it did before. If each point b of a query box went by U(b)
// in one step, in which B came as far as `way`, and B comes as far as w from then on, b has gone by
// (w / way) U(b) and no further from there than what the steps have drifted from that in all. So a
// gap g along n lasts as long as
//   w (r |turn| - n . U(c)) / way + deviation < g,
// in a ball of radius r around c, whatever the motion does. With deviation <= kDrift w, which a
// motion spent sees to that runs as fast as the larger of w and deviation / kDrift, it lasts until
// that motion spent is at
//   g / (kDrift + (r |turn| - n . U(c)) / way),
// where the quotient is no less than 0 and the sum no more than 1, because no point comes further
// than w.

namespace graze::bvh {

/// How far a query box may deviation from its predicted motion, for each unit that it goes.
inline constexpr float kDeviation = 0.0625f;

/// How query boxes of both trees, in the frames of their tested nodes, are expected to go on.
class MotionPrediction {
 public:
  MotionPrediction() = default;

  /// As they came from one pair of frames, of B in A and of A in B, to another: B by `way`, its
  /// rotation changed by `turn`.
  MotionPrediction(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                   const WideTree& tree_a, const WideTree& tree_b, double way, double turn);

  /// How far, at most, a point of either query box has come between these frames from where it was
  /// to come while B came as far as `way`.
  double deviation(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                   double way) const;

  /// Of query boxes of that tested node.
  const FrontWay& step(int tested_side) const { return step_[tested_side]; }
  float per_way() const { return static_cast<float>(1 / way_); }

 private:
  struct Query {
    double rotation[3][3] = {};  // changes
    double translation[3] = {};
    double middle[3] = {};  // of its box, common units
    double half[3] = {};

    double deviation(const RelativeFrame& before, const RelativeFrame& now, double share) const;
  };

  Query query_[2];  // of tested nodes A and B
  FrontWay step_[2];
  double way_ = 1;
};

}  // namespace graze::bvh
