#pragma once

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/work.h>

namespace graze {

/// True if and only if some placed triangle of A shares a point with some placed triangle of B
/// (laws 1 and 2), or for Hit::Crossing crosses() one. Surfaces only, unless Hit::Solid says
/// otherwise: a mesh wholly inside another does not touch it. Stops at the first pair; only where
/// there is none, one placed vertex of each connected part is asked whether the other mesh encloses
/// it, exactly. Throws PoseError for a pose that is refused by law 10 or by law 1, InputError for
/// settings that are none, and with Hit::Solid MeshError, which names the mesh and its number of
/// boundary edges, for one that is not closed.
bool intersects(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Work* work = nullptr);
bool intersects(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                const QuerySettings& settings, Work* work = nullptr);

/// All such pairs, sorted. Throws as intersects() does.
TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  const PairSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
