#pragma once

// This is private to engine.

#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>

#include <vector>

namespace graze {

/// Writes all pairs of find_triangle_pairs() into a list that is used again: what it held is gone.
/// Throws PoseError.
void find_triangle_pairs_into(std::vector<TrianglePair>& pairs, const PlacedMeshView& mesh_a,
                              const PlacedMeshView& mesh_b, Work& work);

}  // namespace graze
