#pragma once

// What a triangle's plane says of other points, exactly, for coordinates of either kind.

#include <graze/narrowphase/predicates/corners.h>
#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/predicates/predicates.h>

namespace graze::narrowphase {

/// On which sides of the plane of a triangle the vertices of another lie.
struct Sides {
  Sign sign[3];

  bool are_equal() const { return sign[0] == sign[1] && sign[1] == sign[2]; }
  bool are_all_zero() const { return are_equal() && sign[0] == Sign::Zero; }
};

Sides sides_of_plane(const Corners<double>& plane, const Corners<double>& other);
Sides sides_of_plane(const Corners<std::int64_t>& plane, const Corners<std::int64_t>& other);

/// An axis along which the triangle's projection has area; negative for a triangle without any.
int projection_axis(const Corners<double>& triangle);
int projection_axis(const Corners<std::int64_t>& triangle);

}  // namespace graze::narrowphase
