#pragma once

#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <graze/bvh/volume.h>
#include <graze/engine/mesh/mesh.h>

#include <array>
#include <optional>

namespace graze {

// The next functions make volumes around all vertices that a mesh's triangles use, as bvh/fit makes
// them; the box along the axes is Mesh::bounds(). Each call computes its volume anew. All throw
// InputError where the volume overflows.

/// Returns the smallest sphere. The time is linear in practice.
Sphere bounding_sphere(const Mesh& mesh);

/// Returns a box that is turned until no turn about one of its axes makes it smaller. Each turn
/// takes O(n log n).
Obb bounding_obb(const Mesh& mesh);

/// Returns the smallest k-DOP; its sums of coordinates are rounded outward. The time is linear.
KDop<18> bounding_kdop(const Mesh& mesh);

/// Returns the volume that the surface of a closed mesh encloses, m^3, by the divergence theorem:
/// positive if its triangles are counterclockwise seen from outside. What the surface winds around
/// twice counts twice; parts that are inside out are taken off. Of an open mesh it says nothing. It
/// is taken about the middle of the bounds and summed with compensation: the error is about 1e-15
/// of what the triangles and that middle span, however many there are.
double signed_volume(const Mesh& mesh);

/// Says how well a volume fits a mesh.
struct VolumeFit {
  Volume type;     ///< the kind of volume
  double volume;   ///< m^3
  double surface;  ///< m^2
  /// The empty share of the volume if the mesh is closed: (volume - enclosed volume) / volume, from
  /// 0 for a perfect fit to 1. Nothing if the mesh is open, if the volume is 0, or if
  /// either overflows.
  std::optional<double> empty_share;
  /// If the mesh is open, the volume divided by that of the mesh's bounds; nothing if it is closed,
  /// if that of the bounds is 0, or if either overflows.
  std::optional<double> relative_volume;

  bool operator==(const VolumeFit&) const = default;
};

/// Says how well each kind of volume fits a mesh.
struct MeshFit {
  /// |signed_volume| if the mesh is closed, m^3: a mesh that is inside out encloses as much. If the
  /// mesh crosses itself or has parts that are inside out, it is only a measure: an empty share
  /// that would be negative by it is given as 0.
  std::optional<double> enclosed_volume;
  std::array<VolumeFit, 4> volumes;  ///< in this order: Aabb, Sphere, Obb, KDop

  bool operator==(const MeshFit&) const = default;
};

/// Fits all four volumes and measures them.
MeshFit measure_fit(const Mesh& mesh);

}  // namespace graze
