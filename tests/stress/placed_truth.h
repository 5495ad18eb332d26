#pragma once

#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>

#include <vector>

namespace graze::stress {

/// The pairs of placed triangles that are not further apart than `margin` metres along any of the
/// axes that separate triangles, by plain arithmetic on all pairs whose boxes come that near. The
/// margin must be far above the rounding of the coordinates: then all other pairs are apart, and
/// stay so under any motion of less than half of it. O(n log n + overlapping boxes).
std::vector<TrianglePair> near_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                     double margin);

/// Whether one of these pairs intersects, by the referee.
bool is_any_hit(const std::vector<TrianglePair>& pairs, const PlacedMesh& mesh_a,
                const PlacedMesh& mesh_b);

}  // namespace graze::stress
