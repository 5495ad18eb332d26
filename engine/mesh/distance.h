#pragma once

#include <graze/engine/mesh/pair.h>
#include <optional>

namespace graze {

/// How far apart two placed meshes are, metres, and where, in the common frame.
struct MeshDistance {
  double distance;          ///< metres; 0 if the surfaces meet
  Eigen::Vector3d point_a;  ///< the point of mesh A that is nearest to B
  Eigen::Vector3d point_b;  ///< and that of B nearest to A
  TrianglePair pair;        ///< the triangles that these lie in

  bool operator==(const MeshDistance&) const = default;
};

/// What distance() and within() can be told.
struct DistanceSettings {
  /// A pair to look at first, such as the result of a query before the meshes moved a little: it
  /// saves time and changes no result.
  std::optional<TrianglePair> hint;
};

/// The least distance() of a placed triangle of A and one of B (laws 1 and 7); of equal ones, that
/// of the lowest pair. It is 0 if and only if intersects() says yes: surfaces only, and then the
/// pair is one that meets, the one that a query for pairs with a limit of 1 begins with. Swapping A
/// and B mirrors distance and points where one pair alone is nearest. Throws PoseError for a pose
/// that is refused by law 10 or by law 1, InputError for a hint that is out of range. Bounds of
/// boxes after Quinlan, "Efficient distance computation between non-convex objects", ICRA 1994:
/// depth first, nearer boxes before others.
MeshDistance distance(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                      const DistanceSettings& settings = {}, Work* work = nullptr);

/// distance() <= clearance, without finding the distance: it stops at the first pair of triangles
/// that is as near, and skips all that is surely further. Throws as distance() does, and InputError
/// for a clearance that is negative or NaN.
bool within(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, double clearance,
            const DistanceSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
