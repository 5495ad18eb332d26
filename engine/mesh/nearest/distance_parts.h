#pragma once

// Queries of distances share these. They are private to engine/mesh.

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <graze/narrowphase/triangle_distance.h>

#include <optional>

namespace graze {

/// Throws InputError for a hint that is out of range.
void check_hint(const DistanceSettings& settings, const Mesh& mesh_a, const Mesh& mesh_b);

/// Throws InputError for a clearance that is negative or NaN.
void check_clearance(double clearance);

/// Returns the largest coordinate that a placed vertex can have.
double largest_of(const PlacedMeshView& placed);

MeshDistance result_of(const TriangleDistance& found, TrianglePair pair);

TriangleDistance distance_of(const Triangle& triangle_a, const Triangle& triangle_b, Work& work);
TriangleDistance distance_of(const WideQuery& query, TrianglePair pair, Work& work);

/// Answers distance() for meshes that are placed and a hint that is in range.
MeshDistance find_distance(const WideQuery& query, std::optional<TrianglePair> hint, Work& work);

/// Answers distance() for two meshes of which it is known that no triangles meet.
MeshDistance distance_apart(const WideQuery& query, TrianglePair hint, Work& work);

/// Returns a pair within the clearance, if there is one: the hint, or the first that the walk comes
/// by.
std::optional<TrianglePair> find_within(const WideQuery& query, double clearance,
                                        std::optional<TrianglePair> hint, Work& work);

}  // namespace graze
