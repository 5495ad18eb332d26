#pragma once

#include <graze/narrowphase/triangle_distance.h>

namespace graze::narrowphase {

/// Holds a direction along which triangles may be seen to be further apart than a limit. To look
/// along it is cheaper than their distance, and often enough where neighbours of a known pair are
/// asked about.
class DirectedGap {
 public:
  /// Takes a bound `largest` of all coordinates of the triangles. Without a direction nothing is
  /// sure.
  explicit DirectedGap(double largest);

  /// Takes the direction from the nearest point of A to that of B. A distance that is very small or
  /// large gives no direction.
  void set_direction(const TriangleDistance& found);

  /// Returns the direction, of length 1 but for rounding, or 0.
  const double (&direction() const)[3] { return direction_; }

  /// Return the largest coordinate of a triangle A along the direction, and the smallest of a
  /// triangle B.
  double end_of(const Triangle& triangle_a) const;
  double start_of(const Triangle& triangle_b) const;

  /// True if no distance() of two such triangles is `limit` or less.
  bool is_beyond(double limit, double end_a, double start_b) const {
    return start_b - end_a > limit + margin_;
  }

 private:
  double direction_[3] = {0, 0, 0};
  double margin_;
};

}  // namespace graze::narrowphase
