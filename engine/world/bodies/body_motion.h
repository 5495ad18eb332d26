#pragma once

// Bounds how far bodies can have moved, for pairs that need not be tested again. Private to
// engine/world.

#include <graze/bvh/pose.h>
#include <graze/engine/world/shapes/next_double.h>

#include <cstdint>
#include <limits>

namespace graze {

/// Returns a length, metres, such that no point of a body, at most `bounding_radius` from its
/// frame's origin, is further than that from where it was, each place as rounding leaves it. It is
/// infinite for an infinite radius.
double motion_bound(const Pose& from, const Pose& to, double bounding_radius);

/// Returns such a bound from any place along RigidMotion::between() to its end.
double travel_bound(const Pose& from, const Pose& to, double bounding_radius);

/// Returns the path with one more motion of the body added, rounded up.
double longer_path(double path, double motion);

/// Says when to measure the gap of a pair: that costs time, and saves tests while the gap lasts.
struct GapCost {
  std::uint16_t first_wait;  ///< how many tests find the two apart before the gap is measured
  std::uint16_t
      worth_it;  ///< how many tests the gap must save, or else the next measurement waits longer
};
/// Measuring two meshes takes as long as some twenty tests that find them apart.
inline constexpr GapCost kMeasuredGap{3, 16};
inline constexpr GapCost kQuickGap{0, 2};

/// Keeps the gap of two bodies that were found apart, and tells when to measure it.
class KnownGap {
 public:
  /// True if paths of these lengths, begun before, cannot have closed the gap.
  bool holds(double path_a, double path_b) const { return next_up(path_a + path_b) < limit_; }

  /// Counts a test that was left out.
  void note_skip() { ++skips_; }

  /// Notes that the pair was tested and found apart. Returns true if knowing the gap is likely to
  /// be worth its cost: not at once, and seldom where the last gap was soon used up.
  bool wants_gap(const GapCost& cost);
  void set_gap(double gap, double path_a, double path_b);

 private:
  static constexpr std::uint16_t kLongestWait = 255;
  static constexpr std::uint16_t kNotAsked = 0xffff;

  double limit_ = -std::numeric_limits<double>::infinity();  ///< the gap holds while the sum of
                                                             ///< both paths is below this
  std::uint32_t skips_ = 0;         ///< the tests saved since the gap was measured
  std::uint16_t wait_ = kNotAsked;  ///< the number of tests before the next measurement
  std::uint16_t tests_left_ = 0;
};

}  // namespace graze
