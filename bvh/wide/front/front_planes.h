#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

// How a gap along a direction n changes with the pose: the bound of motion that decides when a pair
// of a front has to be compared again. It stands in for the failure time of a certificate in a
// kinetic data structure (Basch, Guibas and Hershberger, "Data structures for mobile data", 1999).
//
// In the frame of the tested node's tree, in common units,
// a point b of the query box lies at R b + t in one pose and at S b + v in another. If all b of a
// query box around c, |b - c| <= r, were g or more beyond some points of the tested node along n,
// |n| <= 1, they are now beyond these by at least
//   g + n . ((S - R) c + (v - t)) - r |S - R|.
// With the pose O, o at begin(), u = (R - O) c + (t - o) and u' = (S - O) c + (v - o) that is g + n
// . (u' - u) - r |S - R|, and |S - R| is no more than what the turns of all steps between add up
// to.

namespace graze::bvh {

/// How the points of query boxes are displaced between two poses, in the frame of the tested nodes'
/// tree: b by turned * b + moved, in common units.
struct QueryDisplacement {
  float turned[3][3] = {};  ///< the change of the rotation
  float moved[3] = {};      ///< the change of the translation
  float turn = 0;           ///< the sum of all changes of the rotation on the way, as lengths
  float error = 0;          ///< of n . u for any point of the query boxes' tree, whatever rounds

  QueryDisplacement() = default;

  /// From `first` to `now`, which are frames of the tree `query` in that of the tested nodes.
  QueryDisplacement(const RelativeFrame& first, const RelativeFrame& now, const WideTree& query,
                    double all_turns);
};

/// A ball around what a query box holds, in the frame of its own tree and in common units.
struct FrontQuery {
  float centre[3];
  std::uint16_t upper_radius;  ///< the upper half of a float, rounded up
  std::uint16_t tested_side;   ///< the side of the node that it is tested against

  FrontQuery() = default;
  FrontQuery(const WideChildRef& child, float units, int side_of_tested);

  float radius() const { return std::bit_cast<float>(std::uint32_t{upper_radius} << 16); }
};

/// Gaps of planes are multiplied by this where they are stored, and once more where they are read.
/// It covers four roundings each, and those of turns.
inline constexpr float kRoundPlanes = 1 - 0x1p-20f;

/// A number rounded to float and multiplied by this is no larger than it was before.
inline constexpr float kRoundDown = 1 - 0x1p-22f;

/// How far the middle of a query box has come since begin().
inline void set_step(float (&step)[3], const FrontQuery& query,
                     const QueryDisplacement& displacement) {
  for (int i = 0; i < 3; ++i) {
    step[i] = displacement.turned[i][0] * query.centre[0] +
              displacement.turned[i][1] * query.centre[1] +
              displacement.turned[i][2] * query.centre[2] + displacement.moved[i];
  }
}

/// The plane that keeps one pair out, as in FrontPlanes. At first there is none.
struct FrontPlane {
  float normal[3] = {};
  float gap = -std::numeric_limits<float>::infinity();

  FrontPlane() = default;

  /// The query box is `gap_now` beyond the tested node, after this displacement.
  FrontPlane(const double (&direction)[3], double gap_now, const FrontQuery& query,
             const QueryDisplacement& displacement);

  /// The least gap along the normal after another displacement.
  float gap_after(const FrontQuery& query, const QueryDisplacement& displacement) const;
};

/// What the bounds of a front are good at: telling that things are apart at all, or how far.
enum class FrontBounds { Meeting, Distance };

/// What keeps pairs out: lane by lane a direction in the tested node's frame, no longer than 1 but
/// for rounding, which kRoundPlanes covers, and how far beyond the tested node a query box is
/// along it. Gaps are those of the pose at begin(), but for what turning may have cost; infinite in
/// lanes that need no plane. Nothing is kept out at first.
template <std::size_t lanes, FrontBounds bounds>
struct FrontPlanes;

/// A pass reads thousands of these, in no order, so that they had better be few cache lines.
/// Components of normals are integers that count in kPart. A normal is shortened before it is
/// rounded, so that none is longer than 1.
template <std::size_t lanes>
struct alignas(4 * lanes) FrontPlanes<lanes, FrontBounds::Meeting> {
  static constexpr float kPart = 0x1p-15f;
  static constexpr float kParts = 0x1p15f - 2;

  float gap[lanes];
  std::int16_t normal[3][lanes];
  FrontQuery query;

  FrontPlanes() : normal{}, query{} {
    std::fill_n(gap, lanes, -std::numeric_limits<float>::infinity());
  }
};

/// The nearest pair is looked for among pairs that are nearly as far apart, so that rounding must
/// cost far less than a thousandth of a gap: normals are floats.
template <std::size_t lanes>
struct alignas(4 * lanes) FrontPlanes<lanes, FrontBounds::Distance> {
  static constexpr float kPart = 1;

  float normal[3][lanes];
  float gap[lanes];
  FrontQuery query;

  FrontPlanes() : normal{}, query{} {
    std::fill_n(gap, lanes, -std::numeric_limits<float>::infinity());
  }
};

/// The same as they are found: directions as they will be stored, in parts, the gap along what they
/// were before, and that along themselves.
template <std::size_t lanes>
struct alignas(64) FoundPlanes {
  float normal[3][lanes];
  float gap[lanes];
  float stored_gap[lanes];
};

}  // namespace graze::bvh
