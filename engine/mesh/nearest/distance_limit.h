#pragma once

// This is private to engine/mesh.

#include <graze/bvh/wide/walk/wide_distance_walk.h>
#include <graze/engine/mesh/placing/relative_frame.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

/// Tells which bounds of boxes are beyond a distance in metres. A bound is a length in the common
/// frame y = R_A^T p, along axes of which those of B are the columns of C = R_A^T R_B
/// (relative_frame.cpp, whose slack the bound has taken off). Neither is quite a rotation: lengths
/// there are longer than in space by at most the spectral norms 1 + 1.5 dev_A and 1 + 1.5 g, g =
/// 3.01 dev_A + dev_B + 12 u. The computed bound is off by less than 16 u of itself.
///
/// A distance as returned may be less than the true one, by 4 ulp of a difference of coordinates: 8
/// u times at most 1.8 (tau + 8), in common units, in which centres are tau and boxes 4 apart.
class DistanceLimit {
 public:
  DistanceLimit(const PlacedFrame& a, const PlacedFrame& b, const bvh::RelativeFrame& relative)
      : per_metre_(std::ldexp(1.0, -std::max(a.frame.exponent, b.frame.exponent))) {
    const double gram = 3.01 * a.deviation + b.deviation + 64 * 0x1p-53;
    growth_ = 1 + 2 * (a.deviation + gram);
    const double* t = relative.translation;
    const double tau = std::max(std::abs(t[0]), std::max(std::abs(t[1]), std::abs(t[2])));
    margin_ = 64 * 0x1p-53 * (tau + 16);
    along_margin_ = (8 * (a.deviation + b.deviation) + 0x1p-22) * (tau + 16);
  }

  void shrink_to(double metres) { units_ = (metres * per_metre_ + margin_) * growth_; }

  double units() const { return units_; }

  /// Convert lengths between space and the common frame: placed points that are so far apart in the
  /// one are at least so far apart in the other.
  double least_units(double metres) const { return (metres * per_metre_ - margin_) / growth_; }
  double least_metres(double units) const { return (units / growth_ - margin_) / per_metre_; }

  /// Converts a gap along a direction in space. In either tree's frame it is along what its pose
  /// turns the direction into, as floats: these two differ by at most 3 dev and 1.74 * 2^-24, over
  /// at most 1.74 (tau + 8), which is how far points of both are from each other.
  double least_units_along(double metres) const { return least_units(metres) - along_margin_; }

  double square() const { return units_ * units_; }
  bvh::LengthMargins margins() const { return {growth_, margin_}; }

 private:
  double per_metre_;
  double growth_;
  double margin_;
  double along_margin_;
  double units_ = std::numeric_limits<double>::infinity();
};

}  // namespace graze
