#pragma once

#include <graze/engine/mesh/pair.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// Says how far apart two placed meshes are and where, in the common frame.
struct MeshDistance {
  double distance;          ///< metres; 0 if the surfaces meet
  Eigen::Vector3d point_a;  ///< the point of mesh A that is nearest to B
  Eigen::Vector3d point_b;  ///< the point of mesh B that is nearest to A
  TrianglePair pair;        ///< the triangles in which these points lie

  bool operator==(const MeshDistance&) const = default;
};

/// The settings of distance() and within().
struct DistanceSettings {
  /// A pair to look at first, such as the result of a query before the meshes moved a little: this
  /// saves time and changes no result.
  std::optional<TrianglePair> hint;
};

/// Returns the least distance() of a placed triangle of A and one of B (laws 1 and 7); of equal
/// distances, that of the lowest pair. It is 0 if and only if intersects() says yes, and then the
/// pair is one that meets, the one that a query for pairs with a limit of 1 begins with. Only
/// surfaces count. Swapping A and B mirrors distance and points where one pair alone is nearest.
/// Throws PoseError for a pose that is refused by law 10 or by law 1, InputError for a hint that is
/// out of range. The walk is depth first, nearer boxes before others, with bounds of boxes after
/// Quinlan, "Efficient distance computation between non-convex objects", ICRA 1994.
MeshDistance distance(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                      const DistanceSettings& settings = {}, Work* work = nullptr);

/// True if and only if distance() <= clearance. The distance itself is not searched for: the query
/// stops at the first pair of triangles that is as near, and skips all that is surely further.
/// Throws as distance() does, and InputError for a clearance that is negative or NaN.
bool within(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, double clearance,
            const DistanceSettings& settings = {}, Work* work = nullptr);

/// The point of a placed mesh that is nearest to another point, in the common frame.
struct NearestPoint {
  double distance;         ///< metres; 0 if and only if the point lies on the surface
  Eigen::Vector3d point;   ///< the nearest point of the surface, metres
  std::uint32_t triangle;  ///< the triangle in which it lies; of several the lowest

  bool operator==(const NearestPoint&) const = default;
};

/// Returns the point of the placed surface (law 1) that is nearest to `point`, metres, within the
/// bounds of law 7: the distance is off by at most 4 ulp of the largest difference of coordinates,
/// each coordinate by at most 2 ulp of the largest one. Of equal distances, as they are returned,
/// the lowest triangle counts. Throws InputError for a point that is not finite and PoseError for a
/// pose that is refused by law 10 or by law 1. It takes about O(log n) for points near compact
/// meshes; the first call builds the tree. The walk is depth first, nearer boxes before others.
NearestPoint nearest_point(const PlacedMeshView& mesh, const Eigen::Vector3d& point,
                           Work* work = nullptr);

/// Returns the distance of nearest_point(), metres, with a minus sign if the mesh encloses the
/// point (contains(), by the even-odd rule: whatever way triangles are wound). Throws as both of
/// these do.
double signed_distance(const PlacedMeshView& mesh, const Eigen::Vector3d& point,
                       Work* work = nullptr);

// The next functions answer for many points in one call, which threads share: for each point what
// the single query answers, bit for bit, in the points' order. They throw as that does, before the
// first answer, and name the point by its index. The points are a span, or the rows of a matrix of
// three columns in any storage order; another number of columns is an InputError.

/// Answers nearest_point() for each point.
std::vector<NearestPoint> nearest_points(const PlacedMeshView& mesh,
                                         std::span<const Eigen::Vector3d> points,
                                         const BatchSettings& batch = {}, Work* work = nullptr);
std::vector<NearestPoint> nearest_points(const PlacedMeshView& mesh,
                                         const MatrixView<double>& points,
                                         const BatchSettings& batch = {}, Work* work = nullptr);

/// Answers signed_distance() for each point.
std::vector<double> signed_distances(const PlacedMeshView& mesh,
                                     std::span<const Eigen::Vector3d> points,
                                     const BatchSettings& batch = {}, Work* work = nullptr);
std::vector<double> signed_distances(const PlacedMeshView& mesh, const MatrixView<double>& points,
                                     const BatchSettings& batch = {}, Work* work = nullptr);

}  // namespace graze
