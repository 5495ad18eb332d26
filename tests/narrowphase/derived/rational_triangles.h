#pragma once

// Intersection and distance of two triangles in rational arithmetic, by other formulas than the
// library's: clipping by half-spaces, and the nine pairs of edges and six vertices with a face.

#include <gmpxx.h>

#include <array>
#include <vector>

#include <graze/narrowphase/triangle.h>

namespace graze::oracle {

using RationalPoint = std::array<mpq_class, 3>;

RationalPoint exactly(const Eigen::Vector3d& p);

/// The corners of the intersection, around it; none lies between others.
std::vector<RationalPoint> rational_intersection(const Triangle& a, const Triangle& b);

/// A pair of nearest points.
struct RationalPair {
  RationalPoint a;
  RationalPoint b;
  bool operator==(const RationalPair&) const = default;
};

struct RationalDistance {
  mpq_class square;
  std::vector<RationalPair> nearest;  ///< the corners of the set of all such pairs are among these
};

/// Of triangles that do not meet.
RationalDistance rational_distance(const Triangle& a, const Triangle& b);

mpq_class squared_distance(const RationalPoint& p, const RationalPoint& q);

/// From a point to a closed triangle.
mpq_class squared_distance(const RationalPoint& p, const Triangle& t);

/// One ulp of the largest absolute coordinate, and of the largest difference of a coordinate of A
/// from one of B.
mpq_class ulp_of_coordinates(const Triangle& a, const Triangle& b);
mpq_class ulp_of_differences(const Triangle& a, const Triangle& b);

/// True if all coordinates of the two are at most `reach` apart.
bool are_within(const RationalPoint& exact, const Eigen::Vector3d& rounded, const mpq_class& reach);

}  // namespace graze::oracle
