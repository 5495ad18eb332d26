#pragma once

#include <graze/engine/compare/judge/shape_judge.h>

#include <optional>

namespace graze::compare {

/// Holds the shortest translation by which B leaves A, for two convex bodies, metres; below 0 they
/// are apart by as much.
struct LeastParting {
  double least = 0;           ///< planes across all directions prove that none is shorter
  double most = 0;            ///< a plane across `direction` parts the two once B has gone so far
  Eigen::Vector3d direction;  ///< unit, from A to B
};

/// Returns both bounds, which lie no further apart than `tolerance` unless the search ends first.
///
/// The translation along a direction n is the support of the difference A - B, h(n), and the
/// shortest is the least of h over all directions. The sphere of directions is divided into
/// triangles. Each point p of the difference has h(n) >= p . n, so that the least p . u over a
/// triangle's corners u is a bound for all of it; the triangle of the least bound is divided, until
/// that is near enough to the least h that was met. For two round shapes about one line, but for a
/// quarter of the tolerance, the directions of a half-plane are enough, and arcs are divided. The
/// radii of balls and capsules are added to what is within. A half-space and a plane leave only
/// their own directions. A mesh and a height field count as the hulls of their vertices: what parts
/// these parts the surfaces, which may be parted sooner.
///
/// `proposed` is a direction that may be good. The bounds are computed in double, and off by some
/// ulp of the largest coordinate. Returns nothing for two half-spaces or planes.
std::optional<LeastParting> least_parting(const PlacedBody& a, const PlacedBody& b,
                                          const Eigen::Vector3d& proposed, double tolerance);

}  // namespace graze::compare
