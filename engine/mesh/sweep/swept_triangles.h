#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::contacts {

/// A triangle and its edges in the units of a sweep.
struct SweptTriangle {
  SweptTriangle(const Triangle& placed, double per_metre);

  double corner[3][3];
  double edge[3][3];
};

/// Returns no less than the largest s >= 0 at which b, moved by s along the unit vector, meets a,
/// and more only by what rounding could do; negative if they never meet. If it is not more than
/// `enough`, any such value may be returned.
double last_contact(const SweptTriangle& a, const SweptTriangle& b, const double (&direction)[3],
                    double enough);

}  // namespace graze::contacts
