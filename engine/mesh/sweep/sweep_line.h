#pragma once

#include <graze/engine/mesh/sweep/sweep.h>

namespace graze {

/// A displacement as a sweep takes it: its direction d, with a largest component from 1/2 to 1 in
/// size, scaled by a power of two, so that the translation at a time is s d for s = t 2^exponent in
/// units of the sweep. A component that underflows is off by less than 2^-1074, while s is below 7:
/// the margins cover that.
struct SweepLine {
  SweepLine(const Eigen::Vector3d& displacement, const contacts::SweepUnits& units);

  double direction[3] = {0, 0, 0};
  int exponent = 0;

  /// True if it goes anywhere.
  bool is_any() const { return direction[0] != 0 || direction[1] != 0 || direction[2] != 0; }
  /// Returns no less than s at a time that is no later.
  double at(double time) const;
};

}  // namespace graze
