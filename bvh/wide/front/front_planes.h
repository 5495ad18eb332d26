#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

// How a gap along a direction n changes with the pose. In the tested node's frame, in common units,
// a point b of the query box lies at R b + t in one pose and at S b + v in another. If all b of a
// query box around c, |b - c| <= r, were g or more beyond some points of the tested node along n,
// |n| <= 1, they are now beyond these by at least
//   g + n . ((S - R) c + (v - t)) - r |S - R|.
// With a pose O, o of reference, u = (R - O) c + (t - o) and u' = (S - O) c + (v - o) that is g + n
// . (u' - u) - r |S - R|, and |S - R| is no more than what the turns of all steps between add up
// to.

namespace graze::bvh {

/// How a query box has come from where it was at first, common units.
struct FrontWay {
  float turned[3][3] = {};  // what its rotation has changed by
  float moved[3] = {};
  float turn = 0;   // the sum of all changes of its rotation
  float error = 0;  // of n . u for any point of the query box's tree, whatever rounds

  FrontWay() = default;

  /// From `first` to `now`, as frames of the query box, which is `query`, in the tested node.
  FrontWay(const RelativeFrame& first, const RelativeFrame& now, const WideTree& query,
           double all_turns);
};

/// A query box, as a ball around what its box holds in its own tree's frame, common units.
struct FrontQuery {
  float centre[3];
  std::uint16_t upper_radius;  // the upper half of a float, rounded up
  std::uint16_t tested_side;   // whose query box it is

  FrontQuery() = default;
  FrontQuery(const WideChildRef& slot, float units, int side_of_tested);

  float radius() const { return std::bit_cast<float>(std::uint32_t{upper_radius} << 16); }
};

/// What gaps of planes are multiplied by where they are stored, and where they are read: four
/// roundings each, and those of turns.
inline constexpr float kRoundPlanes = 1 - 0x1p-20f;

/// What is rounded to float, times it, is no more than before.
inline constexpr float kRoundDown = 1 - 0x1p-22f;

/// How far the middle of a query box has come since the pose of reference.
inline void set_step(float (&step)[3], const FrontQuery& query, const FrontWay& way) {
  for (int i = 0; i < 3; ++i) {
    step[i] = way.turned[i][0] * query.centre[0] + way.turned[i][1] * query.centre[1] +
              way.turned[i][2] * query.centre[2] + way.moved[i];
  }
}

/// What keeps one pair out, as in FrontPlanes: nothing as it is made.
struct FrontPlane {
  float normal[3] = {};
  float gap = -std::numeric_limits<float>::infinity();

  FrontPlane() = default;

  /// The query box is `gap_now` beyond the tested node, after this way.
  FrontPlane(const double (&direction)[3], double gap_now, const FrontQuery& query,
             const FrontWay& way);

  /// How far it is at least after another way.
  float gap_after(const FrontQuery& query, const FrontWay& way) const;
};

/// What the bounds of a front are good at: telling that things are apart at all, or how far.
enum class FrontBounds { Meeting, Distance };

/// What keeps pairs out: lane by lane a direction in the tested node's frame, no longer than 1 but
/// for rounding, which kRoundPlanes pays for, and how far beyond the tested node a query box is
/// along it. Gaps are those of the reference pose, but for what turning may have cost; infinite in
/// lanes that need no plane. Nothing is kept out at first.
template <std::size_t lanes, FrontBounds bounds>
struct FrontPlanes;

/// A pass reads thousands of these, in no order, so that they had better be few cache lines.
/// Components of normals are so many parts of 1, rounded, of what is so much shorter that none is
/// longer than 1.
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

/// What is far apart is compared with what is nearly as far: a thousandth of it counts.
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
