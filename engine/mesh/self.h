#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>

namespace graze {

/// True if and only if two triangles of the mesh intersect: what they share is more than the welded
/// vertex or edge that they have in common. Touching elsewhere counts. Duplicates intersect, unless
/// they are segments or points that repeat a corner: these are no more than what they have in
/// common. The answer is exact for every finite mesh.
bool self_intersects(const Mesh& mesh, Work* work = nullptr);
bool self_intersects(const Mesh& mesh, const SelfQuerySettings& settings, Work* work = nullptr);

/// Returns all pairs a < b of the kind that the settings say, sorted.
TrianglePairs find_self_pairs(const Mesh& mesh, const SelfSettings& settings = {},
                              Work* work = nullptr);

}  // namespace graze
