#pragma once

// These are parts of a body in its own frame, metres. They are private to engine/mesh/rigid.

#include <algorithm>
#include <cmath>

namespace graze {

/// Returns the dot product of vectors of three components.
inline double dot_product(const double* a, const double* b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/// The interval of a part along a direction, from where it begins to where it ends.
struct Extent {
  double low;
  double high;
};

/// An oriented box around what a node holds.
struct BodyBox {
  double centre[3];
  double axes[3][3];  ///< rows
  double half[3];
  double axes_error;  ///< the error along any direction of the extents' own rounding to float
  /// No point is further than this from the axis of the body's motion; 0 if the body does not turn.
  double radius;

  Extent along(const double (&m)[3]) const {
    double projected = axes_error;
    for (int i = 0; i < 3; ++i) {
      projected += std::abs(dot_product(m, axes[i])) * half[i];
    }
    const double middle = dot_product(m, centre);
    return {middle - projected, middle + projected};
  }

  /// Returns half of the longest edge.
  double size() const { return std::max(half[0], std::max(half[1], half[2])); }
};

struct BodyTriangle {
  double corners[3][3];
  /// No corner is further than this from the axis of the body's motion; 0 if the body does not
  /// turn.
  double radius;

  Extent along(const double (&m)[3]) const {
    double at[3];
    for (int i = 0; i < 3; ++i) {
      at[i] = dot_product(m, corners[i]);
    }
    return {std::min(at[0], std::min(at[1], at[2])), std::max(at[0], std::max(at[1], at[2]))};
  }
};

}  // namespace graze
