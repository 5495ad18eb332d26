#pragma once

namespace graze::generator {

/// A diameter may lie between nominal + lower and nominal + upper. Millimetres.
struct Deviations {
  double upper;
  double lower;

  double middle() const { return (upper + lower) / 2; }
};

/// The nearest preferred number of the series R40 of ISO 3: ISO 965-1 rounds tolerances to these.
double round_to_r40(double value);

/// What ISO 965-1 allows a thread of nominal diameter d and pitch P, both in millimetres. Computed
/// from the standard's formulas, rounded to R40 micrometres as its tables are.
struct ThreadTolerances {
  Deviations external_major;  ///< d of a 6g bolt
  Deviations external_pitch;  ///< d2 of a 6g bolt
  Deviations internal_pitch;  ///< D2 of a 6H nut
  Deviations internal_minor;  ///< D1 of a 6H nut
};

/// `range_mean` is the geometric mean of the limits of the diameter range that holds d, as in the
/// standard: sqrt(5.6 * 11.2) for M8. Pitches of at least 1 mm.
ThreadTolerances tolerances_6h_6g(double pitch, double range_mean);

}  // namespace graze::generator
