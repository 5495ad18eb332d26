#pragma once

// Private to engine/mesh/rigid: parts of a body in its own frame, metres.

#include <algorithm>
#include <cmath>

namespace graze {

/// Where a part begins and ends along a direction.
struct Extent {
  double low;
  double high;
};

/// An oriented box around what a node holds.
struct BodyBox {
  double centre[3];
  double axes[3][3];  ///< rows
  double half[3];
  double axes_error;  ///< what the extents' own rounding to float can add along any direction
  double radius;      ///< no point is further from the axis of the body's motion

  Extent along(const double (&m)[3]) const {
    double reach = axes_error;
    for (int i = 0; i < 3; ++i) {
      const double(&axis)[3] = axes[i];
      reach += std::abs((m[0] * axis[0] + m[1] * axis[1]) + m[2] * axis[2]) * half[i];
    }
    const double middle = (m[0] * centre[0] + m[1] * centre[1]) + m[2] * centre[2];
    return {middle - reach, middle + reach};
  }

  /// Half of the longest edge.
  double size() const { return std::max(half[0], std::max(half[1], half[2])); }
};

struct BodyTriangle {
  double corners[3][3];
  double radius;  ///< likewise

  Extent along(const double (&m)[3]) const {
    double at[3];
    for (int i = 0; i < 3; ++i) {
      const double(&p)[3] = corners[i];
      at[i] = (m[0] * p[0] + m[1] * p[1]) + m[2] * p[2];
    }
    return {std::min(at[0], std::min(at[1], at[2])), std::max(at[0], std::max(at[1], at[2]))};
  }
};

}  // namespace graze
