#pragma once

namespace graze {
struct Triangle;
}

namespace graze::narrowphase {

enum class Sign : int { Negative = -1, Zero = 0, Positive = 1 };

constexpr Sign operator-(Sign sign) {
  return static_cast<Sign>(-static_cast<int>(sign));
}

/// A point of a plane: two of the three coordinates of a point in space.
struct Point2 {
  double x;
  double y;
};

/// Projects along coordinate axis 0, 1 or 2, keeping the other two in cyclic order, so that areas
/// in the projection are the components of normals in space.
constexpr Point2 project(const double* point, int axis) {
  return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
}

// The predicates are exact for all finite doubles and undefined for others, which the tests that
// call them refuse first. Each goes through the stages of orientation_stages.h.

/// Throws InputError, naming `what` and the vertex, for a coordinate that is not finite.
void check_finite(const Triangle& triangle, const char* what);

/// Returns the sign of (b - a) x (c - a): Positive when a, b, c turn counter-clockwise.
Sign orientation_2d(Point2 a, Point2 b, Point2 c);

/// Returns the sign of ((b - a) x (c - a)) . (d - a): Positive when d lies on the side of the plane
/// through a, b, c to which their normal points. Arguments are arrays of three doubles.
Sign orientation_3d(const double* a, const double* b, const double* c, const double* d);

}  // namespace graze::narrowphase
