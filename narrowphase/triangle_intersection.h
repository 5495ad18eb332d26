#pragma once

#include <algorithm>
#include <array>

#include <graze/narrowphase/triangle.h>

namespace graze {

/// Names the kind of set that two triangles have in common.
enum class IntersectionKind { None, Point, Segment, Polygon };

/// Holds what two closed triangles have in common: nothing, a point, the segment between two
/// points, or, where they lie in one plane, a convex polygon of three to six corners. Metres, in
/// the triangles' frame.
struct TriangleIntersection {
  IntersectionKind kind = IntersectionKind::None;  ///< exact
  int count = 0;                                   ///< the number of corners
  std::array<Eigen::Vector3d, 6> corner;  ///< the first `count` are set; those of a polygon go
                                          ///< around it

  auto begin() const { return corner.begin(); }
  auto end() const { return corner.begin() + count; }

  /// True if the kinds are equal and so are the corners that are set.
  bool operator==(const TriangleIntersection& other) const {
    return kind == other.kind && std::equal(begin(), end(), other.begin(), other.end());
  }
};

/// Returns the intersection of two triangles. Its kind is exact, for every finite input; each
/// coordinate of a corner is off by at most 2 ulp of the largest absolute coordinate of the
/// triangles (law 7). Corners that round to the same doubles are all listed. Neither the order of
/// the triangles nor that of their vertices changes a bit (law 4). Throws InputError for a
/// coordinate that is not finite.
TriangleIntersection intersection(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze
