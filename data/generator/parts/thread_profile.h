#pragma once

#include <vector>

namespace graze::generator {

/// A corner of a thread's outline in a half-plane through the axis. Millimetres.
struct ThreadPoint {
  double r;
  double z;  ///< from the middle of the bolt's crest; for a nut from the middle of its own root,
             ///< which lies opposite the bolt's crest
};

/// One pitch of a thread: its corners by ascending z.
struct ThreadProfile {
  double pitch;
  std::vector<ThreadPoint> points;
};

/// The triangle of ISO 68-1 that a thread is cut from: flanks at 30 degrees to the radius,
/// H = sqrt(3)/2 P high; d2 = d - 3/4 H, d1 = d - 5/4 H.
struct BasicThread {
  double diameter;
  double pitch;

  double height() const;
  double pitch_diameter() const;
  double minor_diameter() const;
};

/// ISO M8, coarse.
inline constexpr BasicThread kM8{8, 1.25};

/// 6g in the middle of its tolerances; the root rounded with H/6, tangent to both flanks.
ThreadProfile external_profile(const BasicThread& basic, double range_mean);

/// 6H in the middle of its tolerances; the root, beyond the nominal diameter, rounded with H/12.
ThreadProfile internal_profile(const BasicThread& basic, double range_mean);

}  // namespace graze::generator
