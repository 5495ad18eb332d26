#pragma once

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/work.h>

namespace graze {

/// True if and only if some placed triangle of A shares a point with some placed triangle of B
/// (laws 1 and 2), or for Hit::Crossing crosses() one. Only surfaces count, unless Hit::Solid says
/// otherwise: a mesh wholly inside another does not touch it. The query stops at the first pair;
/// only where there is none, one placed vertex of each connected part is asked whether the other
/// mesh encloses it, exactly. Throws PoseError for a pose that is refused by law 10 or by law 1,
/// InputError for settings that are not valid, and with Hit::Solid MeshError, which names the mesh
/// and its number of boundary edges, for one that is not closed.
bool intersects(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Work* work = nullptr);
bool intersects(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                const QuerySettings& settings, Work* work = nullptr);

/// Returns all pairs of placed triangles that touch or, as the settings say, cross, sorted. Throws
/// as intersects() does.
TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  const PairSettings& settings = {}, Work* work = nullptr);

/// Returns all these pairs, found by several threads, as in `find_triangle_pairs({bolt}, {nut},
/// {.threads = 0})`. It is a template, with one instance, only so that C++ prefers the function
/// above where the settings name no threads.
template <typename = void>
TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  const SharedPairSettings& settings, Work* work = nullptr);

/// True if and only if the open interiors of two closed meshes, as they are placed (law 1), have a
/// point in common: what both enclose by the even-odd rule (containment.h), without their surfaces.
/// So what merely touches, in a vertex, along an edge or face on face, from outside or from within
/// a cavity, does not overlap, however much of its surface it shares; equal solids do, and so does
/// a solid inside another one that shares faces with it. The answer is exact, whatever way
/// triangles are wound.
///
/// It costs find_triangle_pairs() and tens of microseconds for each triangle that touches the other
/// mesh; where triangles cross() it ends at the first such pair. Meshes may go through themselves:
/// where the answer depends on a triangle whose inside others of its mesh meet, that is asked piece
/// by piece, in integers, which for n of them costs O(n^2). Throws MeshError, which names the mesh
/// and its number of boundary edges, for one that is not closed; PoseError for a pose that is
/// refused by law 10 or by law 1.
bool interiors_intersect(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                         Work* work = nullptr);

}  // namespace graze
