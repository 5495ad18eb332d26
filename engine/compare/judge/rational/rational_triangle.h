#pragma once

#include <graze/bvh/pose.h>
#include <graze/narrowphase/triangle.h>

#include <gmpxx.h>
#include <array>

namespace graze::compare {

using RationalPoint = std::array<mpq_class, 3>;
using RationalTriangle = std::array<RationalPoint, 3>;

bool is_zero(const RationalPoint& p);
RationalPoint minus(const RationalPoint& p, const RationalPoint& q);
mpq_class dot(const RationalPoint& p, const RationalPoint& q);
RationalPoint cross(const RationalPoint& p, const RationalPoint& q);

/// Returns the edge from corner i to the next one.
RationalPoint edge_of(const RationalTriangle& triangle, std::size_t i);

struct Extent {
  mpq_class min;
  mpq_class max;
};
/// Returns the extent of axis . x over the triangle.
Extent extent_of(const RationalTriangle& triangle, const RationalPoint& axis);

/// Return the doubles as they are.
RationalPoint exactly(const Eigen::Vector3d& point);
RationalTriangle exactly(const Triangle& triangle);

/// Returns the triangle as the pose's real numbers place it, without law 1's rounding.
RationalTriangle placed_without_rounding(const Pose& pose, const Triangle& triangle);

/// Returns the square of the distance of two closed triangles; 0 if and only if they share a point.
/// The nearest points are convex combinations of corners. Those that use just the corners of two
/// subsets are stationary points of a quadratic form, found by solving a linear system; the least
/// value over all pairs of subsets whose weights are not negative is the answer. Where a system is
/// singular, the minimum can be moved until it needs fewer corners, so that it is found elsewhere.
/// Takes some tens of microseconds for coordinates of like size.
mpq_class squared_distance(const RationalTriangle& triangle_a, const RationalTriangle& triangle_b);

/// Returns, for triangles that intersect, the square of the shortest translation after which they
/// merely touch: the distance of the origin from the boundary of the difference of the two, whose
/// facets are normal to a triangle or to an edge of each.
mpq_class squared_depth(const RationalTriangle& triangle_a, const RationalTriangle& triangle_b);

/// True if the three corners lie on one line.
bool has_no_area(const RationalTriangle& triangle);

/// Returns the root, rounded to a double that may be off in its last bit; infinite if it is beyond
/// range.
double rounded_root(const mpq_class& square);

/// Return |value - root of square|, rounded in the same way.
double root_error(double value, const mpq_class& square);
double root_error(const mpq_class& value, const mpq_class& square);

/// True if one plane holds all six corners.
bool are_coplanar(const RationalTriangle& triangle_a, const RationalTriangle& triangle_b);

/// True if the relative interiors of the two share a point and no plane holds both: what
/// Touch::Exclude counts. Each triangle is cut with the other's plane; the two open segments that
/// result lie on one line, and overlap or do not (Moeller, "A fast triangle-triangle intersection
/// test", Journal of Graphics Tools 2(2), 1997), here in rational numbers.
bool do_cross(const RationalTriangle& triangle_a, const RationalTriangle& triangle_b);

}  // namespace graze::compare
