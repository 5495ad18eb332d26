#pragma once

// Places vertices of a mesh, for code that places thousands one by one. Private to engine/world.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/narrowphase/convex/core/core.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace graze {

/// Places points by law 1 as place() does, operation by operation, and subtracts an origin.
/// Functions are static as those of vector.h are.
struct MeshPlacing {
  std::span<const Eigen::Vector3d> vertices;
  std::span<const TriangleIndices> triangles;
  const double* m;  ///< column-major 4x4
  narrowphase::Vec3 origin;
};

static inline MeshPlacing placing_of(const PlacedMeshView& mesh, const narrowphase::Vec3& origin) {
  return {mesh.mesh.vertices(), mesh.mesh.triangles(), mesh.pose.data(), origin};
}

static inline narrowphase::Vec3 placed_vertex(const MeshPlacing& by, std::uint32_t vertex) {
  const double* v = by.vertices[vertex].data();
  const double* m = by.m;
  const narrowphase::Vec3 placed{((m[0] * v[0] + m[4] * v[1]) + m[8] * v[2]) + m[12],
                                 ((m[1] * v[0] + m[5] * v[1]) + m[9] * v[2]) + m[13],
                                 ((m[2] * v[0] + m[6] * v[1]) + m[10] * v[2]) + m[14]};
  return placed - by.origin;
}

struct PlacedCorners {
  narrowphase::Vec3 corner[3];
};

static inline PlacedCorners placed_corners(const MeshPlacing& by, std::uint32_t triangle) {
  const TriangleIndices& of = by.triangles[triangle];
  return {{placed_vertex(by, of[0]), placed_vertex(by, of[1]), placed_vertex(by, of[2])}};
}

/// Returns the core of a placed triangle, as core_of() a Triangle does.
static inline narrowphase::Core core_of(const PlacedCorners& triangle) {
  narrowphase::Core core;
  core.kind = narrowphase::CoreKind::Triangle;
  std::copy(triangle.corner, triangle.corner + 3, core.corner);
  core.at = core.corner[0];
  core.bounding_radius =
      std::max(length(core.corner[1] - core.at), length(core.corner[2] - core.at));
  return core;
}

}  // namespace graze
