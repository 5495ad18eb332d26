#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

// This derives how a gap along a direction n changes with the pose: the bound of motion that
// decides when a pair of a front has to be compared again. It stands in for the failure time of a
// certificate in a kinetic data structure (Basch, Guibas and Hershberger, "Data structures for
// mobile data", 1999).
//
// In the frame of the tested node's tree, in common units,
// a point b of the query box lies at R b + t in one pose and at S b + v in another. If all b of a
// query box around c, |b - c| <= r, were g or more beyond some points of the tested node along n,
// |n| <= 1, they are now beyond these by at least
//   g + n . ((S - R) c + (v - t)) - r |S - R|.
// With the pose O, o at begin(), u = (R - O) c + (t - o) and u' = (S - O) c + (v - o) that is g + n
// . (u' - u) - r |S - R|, and |S - R| is no more than what all turns between add up to.

// Predicted motions. A motion mostly goes on as it did before: predicted motion and the deviation
// from it take the place of the known motions of kinetic data structures. Suppose that in the last
// motion, in which B came as far as D, each point b of a query box was displaced by U(b), and that
// B comes as far as w from there on. Then b is displaced by (w / D) U(b), and lies no further from
// there than what all motions have deviated from the prediction in all. So in a ball of radius r
// around c a gap g along n stays above 0 as long as
//   w (r |change of rotation| - n . U(c)) / D + deviation < g,
// whatever the motion does. The motion spent grows as fast as the larger of w and deviation /
// kDeviation, so that the deviation never exceeds kDeviation times the motion spent. Hence the gap
// stays above 0 until the motion spent has grown by
//   g / (kDeviation + (r |change of rotation| - n . U(c)) / D),
// where the second term is at least 0 and the sum at most 1, because no point comes further than w.

namespace graze::bvh {

/// Says how the points of query boxes are displaced between two poses, in the frame of the tested
/// nodes' tree: b by rotation_change * b + translation_change, in common units.
struct QueryDisplacement {
  float rotation_change[3][3] = {};  ///< the change of the rotation
  float translation_change[3] = {};  ///< the change of the translation
  float rotation_sum = 0;  ///< the sum of all changes of the rotation on the way, as lengths
  float error = 0;         ///< the error of n . u for any point of the query boxes' tree, whatever
                           ///< rounds

  QueryDisplacement() = default;

  /// Computes the displacement from `first` to `now`, which are frames of the tree `query` in that
  /// of the tested nodes.
  QueryDisplacement(const RelativeFrame& first, const RelativeFrame& now, const WideTree& query,
                    double all_changes);
};

/// A query box may deviate from its predicted motion by so much for each unit of the motion spent.
inline constexpr float kDeviation = 0.0625f;

/// Predicts how query boxes of both trees, in the frames of their tested nodes, go on.
class MotionPrediction {
 public:
  MotionPrediction() = default;

  /// Predicts that they go on as they came from one pair of frames, of B in A and of A in B, to
  /// another, while no point of B came further than `distance` and its rotation changed by
  /// `rotation_change`.
  MotionPrediction(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                   const WideTree& tree_a, const WideTree& tree_b, double distance,
                   double rotation_change);

  /// Returns the most by which any point of either query box deviated from the prediction between
  /// these frames, while B came as far as `distance`.
  double deviation(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                   double distance) const;

  /// Returns the displacement that query boxes are predicted to repeat, in the frame of the tested
  /// tree.
  const QueryDisplacement& displacement(int tested_side) const {
    return displacement_[tested_side];
  }
  float per_distance() const { return static_cast<float>(1 / distance_); }

 private:
  struct QueryTree {
    double rotation[3][3] = {};  ///< the predicted change of the rotation
    double translation[3] = {};  ///< the predicted change of the translation
    double middle[3] = {};       ///< the middle of the box of everything, common units
    double half[3] = {};

    double deviation(const RelativeFrame& before, const RelativeFrame& now, double share) const;
  };

  QueryTree query_trees_[2];           ///< the tree of the query boxes for each side of the tested
                                       ///< node
  QueryDisplacement displacement_[2];  ///< the predicted displacement, likewise
  double distance_ = 1;                ///< how far B came with it
};

/// The ball around a query box, in the frame of its own tree and in common units.
struct QueryBall {
  float centre[3];
  std::uint16_t upper_radius;  ///< the upper half of a float, rounded up
  std::uint16_t tested_side;   ///< the side of the node that it is tested against

  QueryBall() = default;
  QueryBall(const WideChildRef& child, float units, int side_of_tested);

  float radius() const { return std::bit_cast<float>(std::uint32_t{upper_radius} << 16); }
};

/// Gaps of planes are multiplied by this where they are stored, and once more where they are read.
/// It covers four roundings each, and those of turns.
inline constexpr float kRoundPlanes = 1 - 0x1p-20f;

/// A number rounded to float and multiplied by this is no larger than it was before.
inline constexpr float kRoundDown = 1 - 0x1p-22f;

/// Computes how far the middle of a query box has come since begin().
inline void set_displacement(float (&displaced)[3], const QueryBall& query,
                             const QueryDisplacement& displacement) {
  for (int i = 0; i < 3; ++i) {
    displaced[i] = displacement.rotation_change[i][0] * query.centre[0] +
                   displacement.rotation_change[i][1] * query.centre[1] +
                   displacement.rotation_change[i][2] * query.centre[2] +
                   displacement.translation_change[i];
  }
}

/// The plane that keeps one pair out, as in FrontPlanes. At first there is none.
struct FrontPlane {
  float normal[3] = {};
  float gap = -std::numeric_limits<float>::infinity();

  FrontPlane() = default;

  /// Takes a query box that is `gap_now` beyond the tested node, after this displacement.
  FrontPlane(const double (&direction)[3], double gap_now, const QueryBall& query,
             const QueryDisplacement& displacement);

  /// Returns the least gap along the normal after another displacement.
  float gap_after(const QueryBall& query, const QueryDisplacement& displacement) const;
};

/// The purposes of a front: its planes prove that pairs are apart at all, or also how far.
enum class FrontKind { Intersection, Distance };

/// The planes that keep pairs out: lane by lane a direction in the tested node's frame, no longer
/// than 1 but for rounding, which kRoundPlanes covers, and how far beyond the tested node a query
/// box is along it. Gaps are those of the pose at begin(), but for what turning may have cost; they
/// are infinite in lanes that need no plane. At first they keep nothing out.
template <std::size_t lanes, FrontKind kind>
struct FrontPlanes;

/// The planes that tell whether pairs are apart. A pass reads thousands of these, in no order, so
/// that they had better be few cache lines. Components of normals are whole numbers of kUnit, in 16
/// bits. A normal is made kLength units long before it is rounded, a little less than 1, so that
/// afterwards none is longer than 1.
template <std::size_t lanes>
struct alignas(4 * lanes) FrontPlanes<lanes, FrontKind::Intersection> {
  static constexpr float kUnit = 0x1p-15f;
  static constexpr float kLength = 0x1p15f - 2;

  float gap[lanes];
  std::int16_t normal[3][lanes];
  QueryBall ball;

  FrontPlanes() : normal{}, ball{} {
    std::fill_n(gap, lanes, -std::numeric_limits<float>::infinity());
  }
};

/// The planes that tell how far pairs are apart. The nearest pair is looked for among pairs that
/// are nearly as far apart, so that rounding must cost far less than a thousandth of a gap: normals
/// are floats.
template <std::size_t lanes>
struct alignas(4 * lanes) FrontPlanes<lanes, FrontKind::Distance> {
  static constexpr float kUnit = 1;

  float normal[3][lanes];
  float gap[lanes];
  QueryBall ball;

  FrontPlanes() : normal{}, ball{} {
    std::fill_n(gap, lanes, -std::numeric_limits<float>::infinity());
  }
};

/// Planes as they are found: their normals as they will be stored, in whole units, the gap along
/// the normals before they were rounded to units, and the gap along the stored ones.
template <std::size_t lanes>
struct alignas(64) FoundPlanes {
  float normal[3][lanes];
  float gap[lanes];
  float stored_gap[lanes];
};

}  // namespace graze::bvh
