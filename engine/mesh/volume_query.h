#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>

namespace graze {

/// True if and only if some placed triangle of the mesh shares a point with the closed box or ball
/// (laws 1 and 3). Only the surface counts, unless Interior::Solid says otherwise: a box wholly
/// inside a closed mesh does not touch it. The query stops at the first triangle. Throws MeshError
/// for Interior::Solid and a mesh that is not closed. Throws InputError or PoseError for an invalid
/// box or sphere, PoseError for a pose that is refused by law 10 or by law 1, or an oriented box in
/// whose frame the mesh could overflow.
bool intersects(const PlacedMeshView& mesh, const Aabb& box, Work* work = nullptr);
bool intersects(const PlacedMeshView& mesh, const Obb& box, Work* work = nullptr);
bool intersects(const PlacedMeshView& mesh, const Sphere& sphere, Work* work = nullptr);
bool intersects(const PlacedMeshView& mesh, const Aabb& box, const VolumeQuerySettings& settings,
                Work* work = nullptr);
bool intersects(const PlacedMeshView& mesh, const Obb& box, const VolumeQuerySettings& settings,
                Work* work = nullptr);
bool intersects(const PlacedMeshView& mesh, const Sphere& sphere,
                const VolumeQuerySettings& settings, Work* work = nullptr);

/// Returns all triangles that share a point with the closed box or ball, sorted. Throws as
/// intersects() does.
TriangleList find_triangles(const PlacedMeshView& mesh, const Aabb& box,
                            const TriangleSettings& settings = {}, Work* work = nullptr);
TriangleList find_triangles(const PlacedMeshView& mesh, const Obb& box,
                            const TriangleSettings& settings = {}, Work* work = nullptr);
TriangleList find_triangles(const PlacedMeshView& mesh, const Sphere& sphere,
                            const TriangleSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
