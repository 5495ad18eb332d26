#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::benchmark {

/// How far two triangles are apart, in rational arithmetic and by other formulas than the
/// library's, rounded once at the end, up where nothing would be left; 0 if and only if the referee
/// says that they meet.
double rounded_distance(const Triangle& a, const Triangle& b);

/// One ulp of a number; of numbers below 2^-1022 the smallest double.
double ulp_of(double number);

/// The largest absolute coordinate.
double largest_coordinate(const Triangle& t);

}  // namespace graze::benchmark
