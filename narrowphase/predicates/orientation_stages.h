#pragma once

// Holds the stages of the orientation predicates, in the order in which predicates.cpp asks them.
// An empty answer means: ask the next stage. All take finite doubles.

#include <graze/narrowphase/predicates/predicates.h>
#include <optional>

namespace graze::narrowphase {

/// Ask rounded arithmetic with a forward error bound; they also return zeros that equal coordinates
/// certify.
std::optional<Sign> orientation_2d_filter(Point2 a, Point2 b, Point2 c);
std::optional<Sign> orientation_3d_filter(const double* a, const double* b, const double* c,
                                          const double* d);

/// Says how four points lie around a vertex v in the plane: the sign of (x - v) x (y - v) for two
/// of them, x and y, and 0 where orientation_2d_filter() has none that is not zero.
struct FanSides {
  int a_b, c_d, a_c, a_d, b_c, b_d;
};
FanSides fan_filter(Point2 vertex, Point2 a, Point2 b, Point2 c, Point2 d);

/// Ask Shewchuk's expansions, which are exact; the answer is empty when a coordinate is so large or
/// small that a product of differences could overflow or underflow.
std::optional<Sign> orientation_2d_expansion(Point2 a, Point2 b, Point2 c);
std::optional<Sign> orientation_3d_expansion(const double* a, const double* b, const double* c,
                                             const double* d);

/// Ask integers wide enough for every finite double, which are exact.
Sign orientation_2d_big(Point2 a, Point2 b, Point2 c);
Sign orientation_3d_big(const double* a, const double* b, const double* c, const double* d);

}  // namespace graze::narrowphase
