#pragma once

// The stages of the orientation predicates, in the order in which predicates.cpp asks them. An
// empty answer means: ask the next stage. All take finite doubles.

#include <graze/narrowphase/predicates/predicates.h>
#include <optional>

namespace graze::narrowphase {

/// Rounded arithmetic with a forward error bound; also zeros that equal coordinates certify.
std::optional<Sign> orientation_2d_filter(Point2 a, Point2 b, Point2 c);
std::optional<Sign> orientation_3d_filter(const double* a, const double* b, const double* c,
                                          const double* d);

/// How four points lie around a vertex v in the plane: of two of them, x and y, the sign of
/// (x - v) x (y - v), 0 where orientation_2d_filter() has none that is not zero.
struct FanSides {
  int a_b, c_d, a_c, a_d, b_c, b_d;
};
FanSides fan_filter(Point2 vertex, Point2 a, Point2 b, Point2 c, Point2 d);

/// Exact by Shewchuk's expansions; empty when a coordinate is so large or small that a product of
/// differences could overflow or underflow.
std::optional<Sign> orientation_2d_expansion(Point2 a, Point2 b, Point2 c);
std::optional<Sign> orientation_3d_expansion(const double* a, const double* b, const double* c,
                                             const double* d);

/// Exact by integers wide enough for every finite double.
Sign orientation_2d_big(Point2 a, Point2 b, Point2 c);
Sign orientation_3d_big(const double* a, const double* b, const double* c, const double* d);

}  // namespace graze::narrowphase
