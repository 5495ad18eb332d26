#pragma once

// Finds when a box that goes straight is near another. Private to engine/world.

#include <algorithm>

namespace graze {

/// The times at which something is near a box: from the first to the last, or never, if the first
/// is above the last.
struct NearTimes {
  double first, last;

  bool is_never() const { return !(first <= last); }
};

/// A box that goes along a shift while t goes from 0 to 1.
struct BoxSweep {
  double min[3];
  double max[3];
  double shift[3];

  /// Returns when it shares a point with another box, which rests, by the slabs of that, grown by
  /// this box (Kay, Kajiya, "Ray tracing complex scenes", 1986). The box must have room for
  /// rounding: times are off by less than the shift takes for 2^-50 of the coordinates.
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
