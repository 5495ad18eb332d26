#pragma once

// Finds when a convex set that goes straight meets another one. Private to engine/world.

#include <graze/engine/work.h>
#include <graze/narrowphase/convex/core/core.h>

#include <optional>

namespace graze {

/// The place at which two sets meet, relative to the origin of their cores, and the time.
struct StraightMeeting {
  double time;
  narrowphase::Vec3 point;   ///< a point of the set that rests
  narrowphase::Vec3 normal;  ///< unit, from the set that rests to the other one
};

/// Two convex sets of which the second one moves by t `displacement` while t goes from 0 to 1; it
/// must be no triangle. All in metres.
struct StraightPair {
  const narrowphase::Core& still;
  const narrowphase::Core& moving;  ///< the moving set at t = 0
  narrowphase::Vec3 displacement;

  /// Returns the scale of times and distances.
  double scale() const;
};

/// A stretch of time within [0, 1].
struct TimeStretch {
  double from = 0;
  double until = 1;
};

/// Returns the first time at which the two are proved to be no further apart than kTouchTolerance
/// of the scale, or at which the search ends; nothing if they stay apart. Before `from` they are
/// known to be apart, and meetings after `until` do not count.
std::optional<StraightMeeting> first_meeting(const StraightPair& pair, const TimeStretch& stretch,
                                             Work& work);

}  // namespace graze
