#pragma once

#include <vector>

#include "data/generator/parts/thread_profile.h"

namespace graze::generator {

/// Where a helical line of a thread passes through a half-plane. Millimetres.
struct ThreadLine {
  int index;  ///< ascends with z; increases by the number of the profile's points per pitch
  double r;
  double z;
};

struct Range {
  double lower;
  double upper;
};

struct ColumnAngle {
  int column;
  int columns;
};

/// ISO 965-1 groups nominal diameters; M8 lies in the range 5.6 mm to 11.2 mm.
extern const double kM8RangeMean;

/// The lines of a right-handed thread that pass through the half-plane between the ends of `range`,
/// by ascending z. Lines that come nearer to an end than 0.02 mm are left out: no slivers there.
std::vector<ThreadLine> thread_lines(const ThreadProfile& profile, const Range& range,
                                     const ColumnAngle& angle);

}  // namespace graze::generator
