#pragma once

#include <vector>

namespace graze::generator {

/// A spur gear as a rack of the basic profile ISO 53 A generates it: pressure angle 20 degrees,
/// addendum m, dedendum 1.25 m, tool tip rounded with 0.38 m. No profile shift. Millimetres.
struct SpurGear {
  int teeth;
  double module;
  double thinning;  ///< how much narrower than half a pitch a tooth is, on the reference circle

  double reference_radius() const;
  double base_radius() const;
  double tip_radius() const;
  double root_radius() const;

  /// Where the fillet turns into the involute (ISO 21771). Throws std::domain_error when the gear
  /// has so few teeth, below 18, that the tool would undercut the involute.
  double form_radius() const;
};

/// A point of a tooth's flank: distance from the gear's axis, and angle from the middle of the
/// tooth.
struct FlankPoint {
  double radius;
  double angle;
};

/// The flank from the root circle to the tip: `fillet_steps` steps up to the form radius, then
/// `involute_steps` of equal roll angle. Radii strictly ascend, angles strictly descend.
std::vector<FlankPoint> flank(const SpurGear& gear, int fillet_steps, int involute_steps);

}  // namespace graze::generator
