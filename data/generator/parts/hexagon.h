#pragma once

namespace graze::generator {

/// The outside of a hexagon head or nut whose corners are turned off by a cone at 30 degrees to
/// the end face. Flats face the angles 0, 60, ... degrees. Millimetres.
struct Hexagon {
  double across_flats;

  /// Distance from the axis to the outside, for column `column` of `columns` around (a multiple of
  /// 12, so that the corners are columns).
  double radius(int column, int columns) const;

  /// Radius of the circle in which cone and end face meet: a little inside the flats, so that the
  /// cone cuts all around.
  double chamfer_radius() const;

  /// How far below the end face the cone meets the outside at distance `radius`.
  double chamfer_depth(double radius) const;
};

}  // namespace graze::generator
