#pragma once

// What queries of distances share. Private to engine/mesh.

#include <graze/engine/mesh/distance.h>
#include <graze/narrowphase/derived/triangle_distance.h>

#include <optional>

namespace graze {

/// Throws InputError for a hint that is out of range.
void check_hint(const DistanceSettings& settings, const Mesh& mesh_a, const Mesh& mesh_b);

/// Throws InputError for one that is negative or NaN.
void check_clearance(double clearance);

/// The largest coordinate that a placed vertex can have.
double largest_of(const PlacedMesh& placed);

MeshDistance result_of(const TriangleDistance& found, TrianglePair pair);

/// Of two meshes that do meet: which pair this is depends on no direction, hint, memory or kernel.
TrianglePair first_pair_that_meets(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work& work);

/// A pair within the clearance, if there is one: the hint, or the first that the walk comes by.
std::optional<TrianglePair> find_within(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                        double clearance, std::optional<TrianglePair> hint,
                                        Work& work);

}  // namespace graze
