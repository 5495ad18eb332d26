#pragma once

#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape_pairs.h>
#include <Eigen/Core>

namespace graze {

/// By how much two placed shapes are apart, metres, or reach past each other, and where, in the
/// world's frame.
struct ShapeSeparation {
  double distance;          ///< above 0: how far the two are apart; below: minus the depth by which
                            ///< they reach past each other along the normal; 0 if they touch
  Eigen::Vector3d point_a;  ///< of A: apart, the nearest to B; else the deepest in B
  Eigen::Vector3d point_b;  ///< of B, likewise
  Eigen::Vector3d normal;   ///< unit, from A to B: moving B by minus a negative distance along it
                            ///< parts the two, but for the tolerance of depths (manifold.h)
  PairStatus status;        ///< whether the distance, or that the depth is the least, is proved

  bool operator==(const ShapeSeparation&) const = default;
};

/// The signed distance of two convex shapes, half-spaces among them: apart, what distance() says,
/// bit for bit, with its status; else the deepest contact of find_contacts(), bit for bit, whose
/// points and depth are promised there, and Converged unless Work::penetration_failures counts the
/// pair. Above 0 exactly where intersects() is false. Swapping A and B mirrors the result (law 4).
/// Throws as these two do: UnsupportedPairError for two half-spaces that intersect; and for a mesh,
/// which is a surface: signed_distance() is about its points.
ShapeSeparation find_separation(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                                Work* work = nullptr);

}  // namespace graze
