#pragma once

#include <graze/narrowphase/derived/sign_of_products.h>

namespace graze::narrowphase {

inline constexpr double kZeroPoint[3] = {0, 0, 0};
inline constexpr double kAxes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// Returns the unit vector along an axis, so that a component is a product like any other.
constexpr Step axis_step(int axis) {
  return {kZeroPoint, kAxes[axis]};
}

}  // namespace graze::narrowphase
