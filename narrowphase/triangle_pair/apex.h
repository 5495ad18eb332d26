#pragma once

#include <graze/narrowphase/predicates/predicates.h>

namespace graze::narrowphase {

/// The vertex of a triangle that is alone on one closed side of a plane, the other two being on the
/// other closed side, not all three in the plane.
struct Apex {
  int index;
  Sign side;
};

/// Finds it from the signs of the vertices, which are neither all zero nor all of one sign that is
/// not zero. Both edges at the apex then meet the plane, and between the points where they do
/// lies what the triangle and the plane have in common.
constexpr Apex find_apex(const Sign (&signs)[3]) {
  for (int i = 0; i < 3; ++i) {
    const Sign second = signs[(i + 1) % 3];
    const Sign third = signs[(i + 2) % 3];
    if (signs[i] != Sign::Zero && signs[i] != second && signs[i] != third) return {i, signs[i]};
  }
  // Left are two equal signs and a zero: the vertex in the plane is the apex, seen from the
  // others.
  for (int i = 0; i < 3; ++i) {
    if (signs[i] == Sign::Zero) return {i, -signs[(i + 1) % 3]};
  }
  return {0, Sign::Zero};
}

}  // namespace graze::narrowphase
