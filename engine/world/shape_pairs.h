#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/work.h>
#include <graze/engine/world/shape.h>
#include <Eigen/Core>

namespace graze {

/// How a pair of kinds is answered.
enum class PairMethod {
  ExactSpheres,    ///< sphere/sphere: exact, in real arithmetic on the placed doubles
  ExactSphereBox,  ///< exact after law 3's rounding
  BoxAxes,         ///< box/box: the separating axis test with its derived slack
  ClosedForm,      ///< capsules and spheres: distances of points and segments
  Cores,           ///< any other two convex shapes: support mappings
  Plane,           ///< half-space and convex shape: one support point
  Planes,          ///< two half-spaces
  MeshPlane,       ///< half-space and mesh: the lowest vertex
  MeshVolume,      ///< mesh and sphere or box: exact triangle tests
  MeshCore,        ///< mesh and any other convex shape: triangle by triangle near it
  Meshes,          ///< mesh/mesh: exact
};

/// The table of all pairs. Symmetric; every pair has a method. Only contacts of two half-spaces are
/// unsupported: no finite translation parts them.
PairMethod pair_method(ShapeKind kind_a, ShapeKind kind_b);

/// Whether a search ended with an answer that is proved to its tolerance.
enum class PairStatus {
  Converged,
  NotConverged,  ///< neither "apart" nor "touching" was proved: read as a hit (law 11)
};

/// How far apart two placed shapes are, metres, and where, in the world's frame.
struct ShapeDistance {
  double distance;          ///< of the two points; 0 if and only if the shapes intersect
  double lower_bound;       ///< proved: the true distance is not less. For skipping
  Eigen::Vector3d point_a;  ///< nearest points; of intersecting shapes one that is in both, but
  Eigen::Vector3d point_b;  ///< for meshes in which it is near the surface that is met
  Eigen::Vector3d normal;   ///< unit, from A to B; of convex shapes that are apart, the planes at
                            ///< right angles to it that support both are lower_bound apart
  PairStatus status;
};

// All questions: shapes in poses in the world's frame. Convex shapes and half-spaces are solid;
// meshes are surfaces. Swapping A and B gives the same booleans and mirrored results, bit for bit
// (law 4). Throw PoseError for a pose that is refused by law 10 or moves a shape beyond
// kLargestLength.

/// False only if the closed shapes share no point. Exact for spheres among themselves and with
/// boxes and meshes, for boxes with meshes, and mesh/mesh. For all others "apart" alone is sure
/// (law 11): shapes that are apart by less than kTouchTolerance times the scale of the pair (their
/// sizes and the distance of their middles) may come out as intersecting, and a search that does
/// not end counts as a hit and in Work::convex_failures; but never shapes whose boxes, as a World
/// sees them, share no point.
bool intersects(const Shape& shape_a, const Pose& pose_a, const Shape& shape_b, const Pose& pose_b,
                Work* work = nullptr);

/// The distance is off by at most 2^-34 of the scale of the pair where the status is Converged;
/// lower_bound holds whatever the status is. Two half-spaces are apart only where their normals are
/// exactly opposite.
ShapeDistance distance(const Shape& shape_a, const Pose& pose_a, const Shape& shape_b,
                       const Pose& pose_b, Work* work = nullptr);

inline constexpr double kTouchTolerance = 0x1p-34;

}  // namespace graze
