#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze {

/// Names the smallest part of a triangle that holds a point.
enum class Feature { Vertex, Edge, Face };

/// Holds how far apart two closed triangles are, metres, and where. The points are in the
/// triangles' frame.
struct TriangleDistance {
  double distance;          ///< metres
  Eigen::Vector3d point_a;  ///< the point of A nearest to B
  Eigen::Vector3d point_b;  ///< the point of B nearest to A
  Feature feature_a;        ///< the feature of A that holds `point_a` before rounding
  Feature feature_b;        ///< the feature of B that holds `point_b` before rounding

  bool operator==(const TriangleDistance&) const = default;
};

/// Returns the distance of two triangles and their nearest points. The distance is 0 if and only if
/// intersects() says yes; it is off by at most 4 ulp of the largest difference of the triangles'
/// coordinates, and infinite if it is beyond the largest double. Where the nearest points are
/// unique, each of their coordinates is off by at most 2 ulp of the largest absolute coordinate;
/// where they are not, the points are as near to a pair of them. For intersecting triangles both
/// points are one of their intersection. (Law 7, for every finite input.) Swapping A and B mirrors
/// the result, and the order of vertices does not change a bit (law 4). Throws InputError for a
/// coordinate that is not finite.
TriangleDistance distance(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze
