#pragma once

// A box that goes straight. Private to engine/world.

#include <algorithm>

namespace graze {

/// When something is near a box: from one time to another. Never, if the first is above the last.
struct NearTimes {
  double first, last;

  bool is_never() const { return !(first <= last); }
};

/// A box that goes along a shift while t goes from 0 to 1.
struct BoxSweep {
  double min[3];
  double max[3];
  double shift[3];

  /// When it shares a point with another, which rests: its slabs, grown by this box (Kay, Kajiya,
  /// "Ray tracing complex scenes", 1986). The box must have room for rounding: times are off by
  /// less than the shift takes for 2^-50 of the coordinates.
  NearTimes of(const double (&low)[3], const double (&high)[3]) const {
    NearTimes times{0, 1};
    for (int k = 0; k < 3; ++k) {
      const double from = low[k] - max[k], to = high[k] - min[k];
      if (shift[k] == 0) {
        if (from > 0 || to < 0) return {1, 0};
        continue;
      }
      const double s = from / shift[k], t = to / shift[k];
      times.first = std::max(times.first, std::min(s, t));
      times.last = std::min(times.last, std::max(s, t));
    }
    return times;
  }
};

}  // namespace graze
