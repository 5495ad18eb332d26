#pragma once

// A convex set that goes straight to another one. Private to engine/world.

#include <graze/engine/work.h>
#include <graze/narrowphase/convex/core/core.h>

#include <optional>

namespace graze {

/// Where two sets meet, relative to the origin of their cores.
struct StraightMeeting {
  double time;
  narrowphase::Vec3 point;   ///< of the set that stays
  narrowphase::Vec3 normal;  ///< unit, from that to the other one
};

/// Two convex sets of which the second one moves by t `displacement` while t goes from 0 to 1; it
/// must be no triangle. All in metres.
struct StraightPair {
  const narrowphase::Core& still;
  const narrowphase::Core& moving;  ///< where it is at t = 0
  narrowphase::Vec3 displacement;

  /// What times and distances are measured by.
  double scale() const;
};

/// A stretch of time within [0, 1].
struct TimeStretch {
  double from = 0;
  double until = 1;
};

/// The first time at which the two are proved to be no further apart than kTouchTolerance of the
/// scale, or at which the search ends; nothing if they stay apart. Before `from` they are known to
/// be apart, and what meets after `until` is of no interest.
std::optional<StraightMeeting> first_meeting(const StraightPair& pair, const TimeStretch& stretch,
                                             Work& work);

}  // namespace graze
