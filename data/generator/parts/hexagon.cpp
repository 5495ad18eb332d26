#include "data/generator/parts/hexagon.h"

#include <cmath>
#include <numbers>

namespace graze::generator {

double Hexagon::radius(int column, int columns) const {
  const int per_flat = columns / 6;
  const int from_middle = (column + per_flat / 2) % per_flat - per_flat / 2;
  return across_flats / 2 / std::cos(2 * std::numbers::pi * from_middle / columns);
}

double Hexagon::chamfer_radius() const {
  return 0.95 * across_flats / 2;
}

double Hexagon::chamfer_depth(double radius) const {
  return (radius - chamfer_radius()) * std::tan(std::numbers::pi / 6);
}

}  // namespace graze::generator
