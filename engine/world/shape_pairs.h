#pragma once

#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape.h>
#include <Eigen/Core>

namespace graze {

/// The methods by which pairs of kinds are answered.
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

/// Returns the method for a pair of kinds. The table is symmetric, and every pair has a method.
/// Only contacts of two half-spaces are unsupported, because no finite translation parts them.
PairMethod pair_method(ShapeKind kind_a, ShapeKind kind_b);

// Tolerances are stated as shares of sizes and scales, metres. The middle of a shape is the centre
// of a sphere or an ellipsoid, the centre of the box around a hull's corners, and the origin of its
// frame for all others. Its size is the distance of its farthest point from its middle. The
// **scale** of a pair of convex shapes is the sum of both sizes and of the distance of their
// middles; for a mesh the triangle that is met counts, and one of its corners is its middle; a
// half-space has no size, and its middle is the nearest point of its plane.

/// Says whether a search ended with an answer that is proved to its tolerance.
enum class PairStatus {
  Converged,     ///< the distance is off by at most kTouchTolerance times the scale
  NotConverged,  ///< a search ended with bounds further apart than that. The bounds still hold: the
                 ///< true distance is at least `lower_bound` and, unless `distance` is 0, at most
                 ///< the distance of the points. If `lower_bound` is 0, nothing proves the two
                 ///< apart, and a caller who must not miss a hit takes it for one, as intersects()
                 ///< does (law 11). The point of such a hit may be in neither shape: it is midway
                 ///< between one point of each, and how far apart these are is not promised
};

/// The distance of two placed shapes, metres, and their nearest points in the world's frame.
struct ShapeDistance {
  double distance;          ///< the distance of the two points, but for tolerances (see below); 0
                            ///< if and only if intersects() is true
  double lower_bound;       ///< a length that the true distance is proved to be no less than;
                            ///< callers may skip a pair by it
  Eigen::Vector3d point_a;  ///< the point of A nearest to B; for intersecting shapes a point of
                            ///< both, which for a mesh is near the surface that is met
  Eigen::Vector3d point_b;  ///< the point of B nearest to A, or a point of both
  Eigen::Vector3d normal;   ///< unit, from A to B; for convex shapes that are apart, the planes at
                            ///< right angles to it that support both are no nearer to each other
                            ///< than lower_bound, but for 2^-46 of the scale
  PairStatus status;        ///< whether the distance is known to its tolerance

  bool operator==(const ShapeDistance&) const = default;
};

// Rounding moves points by 2^-45 of the scale, or of the world's coordinates where those are
// greater. But for that, points belong to their shapes: they are on the surfaces, or below one by
// at most kTouchTolerance of the scale, where a search for round sides ended within it. If shapes
// touch, or are apart by less than kTouchTolerance of the scale, points are known to that
// tolerance; the distance may exceed the distance of its points, which may coincide: it is then a
// length that boxes or an exact test prove. For a mesh and a convex shape that is no sphere it may
// even be the least double, 4.9e-324: the two are apart, by the exact test or by the boxes of
// triangles, but by less than the distance's tolerance. Where a search leaves open where the shapes
// are nearest, the points are any one of each shape, and the distance is theirs.

// All functions below take shapes in poses in the world's frame, each in one argument:
// `distance({Box{{1, 1, 1}}}, {hull, pose})`. They are templates, with one instance each, only so
// that C++ prefers the functions on meshes for two meshes: `intersects({bolt}, {nut, pose})` is the
// one of pair.h, which answers the same. A mesh may be given with any other shape.
//
// Convex shapes and half-spaces are solid; meshes are surfaces. Swapping A and B gives the same
// booleans and mirrored results, bit for bit (law 4): points change places and normals turn round.
// One case is left out, as no rule could tell A from B: for equal shapes in equal poses, all their
// numbers the same bits, the swapped question is the same one and so is its answer, normal and all.
// The functions throw PoseError for a pose that is refused by law 10 or moves a shape beyond
// kLargestLength.

/// True if the closed shapes share a point. The answer is exact for spheres among themselves and
/// with boxes and meshes, for boxes with meshes, and for two meshes. For all other pairs only
/// "apart" is sure (law 11): shapes that are apart by less than kTouchTolerance times the scale of
/// the pair may come out as intersecting, and a search that does not end counts as a hit and in
/// Work::convex_failures; but never shapes whose boxes, as a World sees them, share no point.
template <typename = void>
bool intersects(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                Work* work = nullptr);

/// Returns the distance of two shapes. It is off by at most kTouchTolerance times the scale of the
/// pair where the status is Converged; lower_bound holds whatever the status is. Where tests find
/// two spheres, a sphere and a box, a sphere and a mesh, or two boxes apart by less than rounding,
/// they are measured again, in twice the precision or by all their features, so that their distance
/// is above 0 and, but for the rounding of the points, the distance of these. So a sphere and a
/// mesh always converge. Two half-spaces are apart only where their normals are exactly opposite.
template <typename = void>
ShapeDistance distance(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                       Work* work = nullptr);

/// The share of the scale of a pair within which two shapes may come out as touching: see law 11.
inline constexpr double kTouchTolerance = 0x1p-34;

}  // namespace graze
