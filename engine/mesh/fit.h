#pragma once

#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <graze/bvh/volume.h>
#include <graze/engine/mesh/mesh.h>

#include <array>
#include <optional>

namespace graze {

// Volumes around all vertices that a mesh's triangles use, as bvh/fit makes them; the box along the
// axes is Mesh::bounds(). Computed anew by each call. All throw InputError where the volume
// overflows.

/// The smallest sphere. Linear in practice.
Sphere bounding_sphere(const Mesh& mesh);

/// A box that is turned until no turn about one of its axes makes it smaller. O(n log n) for each
/// turn.
Obb bounding_obb(const Mesh& mesh);

/// The smallest k-DOP, its sums of coordinates rounded outward. Linear.
KDop<18> bounding_kdop(const Mesh& mesh);

/// What the surface of a closed mesh encloses, m^3: by the divergence theorem, positive if its
/// triangles are counterclockwise seen from outside. What the surface winds around twice counts
/// twice; parts that are inside out are taken off. Of an open mesh it says nothing. Taken about the
/// middle of the bounds and summed with compensation: the error is about 1e-15 of what the
/// triangles and that middle span, however many there are.
double signed_volume(const Mesh& mesh);

/// How well a volume fits a mesh.
struct VolumeFit {
  Volume type;     ///< which kind it is
  double volume;   ///< m^3
  double surface;  ///< m^2
  /// Of a closed mesh the empty share of the volume, (volume - enclosed volume) / volume, from 0
  /// for a perfect fit to 1. Of an open mesh the volume relative to that of the mesh's bounds.
  /// Nothing where either is 0 or overflows.
  std::optional<double> empty_share;
  std::optional<double> relative_volume;  ///< of an open mesh

  bool operator==(const VolumeFit&) const = default;
};

/// How well each kind of volume fits a mesh.
struct MeshFit {
  /// Of a closed mesh, |signed_volume|: a mesh that is inside out encloses as much. Of a mesh that
  /// crosses itself or has parts that are inside out it is only a measure: an empty share that
  /// would be negative by it is given as 0.
  std::optional<double> enclosed_volume;
  std::array<VolumeFit, 4> volumes;  ///< Aabb, Sphere, Obb, KDop

  bool operator==(const MeshFit&) const = default;
};

/// Fits and measures all of them.
MeshFit measure_fit(const Mesh& mesh);

}  // namespace graze
