#pragma once

// This tells on which sides of a plane the vertices of a triangle lie. Exact tests of triangles ask
// it of coordinates of either kind, doubles or the integers of fixed_point.h.

#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <cstdint>

namespace graze::narrowphase {

/// Says on which sides of the plane of a triangle the vertices of another lie. All signs are zero
/// if the triangle has no area.
struct PlaneSides {
  Sign sign[3];

  bool are_equal() const { return sign[0] == sign[1] && sign[1] == sign[2]; }
  bool are_all_zero() const { return are_equal() && sign[0] == Sign::Zero; }
  bool has(Sign asked) const { return sign[0] == asked || sign[1] == asked || sign[2] == asked; }
  bool are_on_both() const { return has(Sign::Negative) && has(Sign::Positive); }

  /// Returns the first vertex of that sign, which at least one of them has.
  int first(Sign asked) const { return sign[0] == asked ? 0 : sign[1] == asked ? 1 : 2; }
};

PlaneSides sides_of_plane(const Corners<double>& plane, const Corners<double>& other);
PlaneSides sides_of_plane(const Corners<std::int64_t>& plane, const Corners<std::int64_t>& other);

/// The vertex of a triangle that is alone on one closed side of a plane, the other two being on the
/// other closed side, not all three in the plane.
struct Apex {
  int index;
  Sign side;
};

/// Finds the apex from the signs of the vertices, which are neither all zero nor all of one sign
/// that is not zero. Both edges at the apex then meet the plane, and between the points where they
/// do lies what the triangle and the plane have in common.
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

/// Returns an axis along which the triangle's projection has area; negative for a triangle without
/// any.
int projection_axis(const Corners<double>& triangle);
int projection_axis(const Corners<std::int64_t>& triangle);

}  // namespace graze::narrowphase
