#pragma once

#include <graze/narrowphase/triangle_distance.h>

namespace graze::narrowphase {

/// A direction along which triangles are surely further apart than a limit: cheaper than their
/// distance, and often enough where neighbours of a known pair are asked about.
class DirectedGap {
 public:
  /// For triangles whose coordinates are at most `largest`. Without a direction nothing is sure.
  explicit DirectedGap(double largest);

  /// Takes the direction from the nearest point of A to that of B. A distance that is very small or
  /// large gives no direction.
  void set_direction(const TriangleDistance& found);

  /// Of length 1 but for rounding, or 0.
  const double (&direction() const)[3] { return direction_; }

  /// The largest coordinate of a triangle A along the direction, and the smallest of a triangle B.
  double end_of(const Triangle& triangle_a) const;
  double start_of(const Triangle& triangle_b) const;

  /// Whether no distance() of two such triangles is `limit` or less.
  bool is_beyond(double limit, double end_a, double start_b) const {
    return start_b - end_a > limit + margin_;
  }

 private:
  double direction_[3] = {0, 0, 0};
  double margin_;
};

}  // namespace graze::narrowphase
