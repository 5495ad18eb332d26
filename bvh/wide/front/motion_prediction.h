#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/front/front_planes.h>
#include <graze/bvh/wide/tree/wide_tree.h>

// A motion mostly goes on as it did before: predicted motion and the deviation from it take the
// place of the known motions of kinetic data structures (Basch, Guibas and Hershberger, "Data
// structures for mobile data", 1999). Suppose that in the last step, in which B came as far as D,
// each point b of a query box was displaced by U(b), and that B comes as far as w from there on.
// Then b is displaced by (w / D) U(b), and lies no further from there than what all steps have
// deviated from the prediction in all. So in a ball of radius r around c a gap g along n lasts as
// long as
//   w (r |turn| - n . U(c)) / D + deviation < g,
// whatever the motion does. The motion spent grows as fast as the larger of w and deviation /
// kDeviation, so that the deviation never exceeds kDeviation times the motion spent. Hence the gap
// lasts until the motion spent has grown by
//   g / (kDeviation + (r |turn| - n . U(c)) / D),
// where the second term is at least 0 and the sum at most 1, because no point comes further than w.

namespace graze::bvh {

/// How far a query box may deviate from its predicted motion, for each unit of the motion spent.
inline constexpr float kDeviation = 0.0625f;

/// How query boxes of both trees, in the frames of their tested nodes, are expected to go on.
class MotionPrediction {
 public:
  MotionPrediction() = default;

  /// As they came from one pair of frames, of B in A and of A in B, to another, while no point of B
  /// came further than `distance` and its rotation changed by `turn`.
  MotionPrediction(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                   const WideTree& tree_a, const WideTree& tree_b, double distance, double turn);

  /// The most by which any point of either query box deviated from the prediction between these
  /// frames, while B came as far as `distance`.
  double deviation(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                   double distance) const;

  /// The displacement that query boxes are predicted to repeat, in the frame of the tested tree.
  const QueryDisplacement& step(int tested_side) const { return step_[tested_side]; }
  float per_distance() const { return static_cast<float>(1 / distance_); }

 private:
  struct Query {
    double rotation[3][3] = {};  ///< the change of it in the predicted step
    double translation[3] = {};  ///< likewise
    double middle[3] = {};       ///< of the box of everything, common units
    double half[3] = {};

    double deviation(const RelativeFrame& before, const RelativeFrame& now, double share) const;
  };

  Query query_[2];             ///< by the side of the tested node
  QueryDisplacement step_[2];  ///< likewise
  double distance_ = 1;        ///< by which B came in the step
};

}  // namespace graze::bvh
