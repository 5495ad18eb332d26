#pragma once

#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape_pairs.h>
#include <Eigen/Core>

namespace graze {

/// The signed distance of two placed shapes, metres, with the points that have it, in the world's
/// frame.
struct ShapeSeparation {
  double distance;  ///< above 0, how far the two are apart; below 0, minus the depth by which they
                    ///< reach past each other along the normal; 0 if they touch
  Eigen::Vector3d point_a;  ///< the point of A nearest to B, or deepest in B
  Eigen::Vector3d point_b;  ///< the point of B nearest to A, or deepest in A
  Eigen::Vector3d normal;   ///< unit, from A to B: moving B by minus a negative distance along it
                            ///< parts the two, but for the tolerance of depths (manifold.h)
  PairStatus status;  ///< whether the distance is proved or, if it is negative, whether the depth
                      ///< is proved to be the least

  bool operator==(const ShapeSeparation&) const = default;
};

/// Returns the signed distance of two convex shapes, either of which may be a half-space. If they
/// are apart, the answer is that of distance(), bit for bit, with its status. Otherwise it is the
/// deepest contact of find_contacts(), bit for bit, whose points and depth are promised there; the
/// status is Converged unless Work::penetration_failures counts the pair. The distance is above 0
/// exactly where intersects() is false. Swapping A and B mirrors the result (law 4). Throws as
/// distance() and find_contacts() do, UnsupportedPairError for two half-spaces that intersect, and
/// UnsupportedPairError for a mesh, which is a surface: signed_distance() is about its points.
ShapeSeparation find_separation(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                                Work* work = nullptr);

}  // namespace graze
