#pragma once

#include <cstddef>
#include <limits>

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>

namespace graze {

/// Which pairs of a mesh with itself are wanted.
enum class SelfPairKind {
  Crossing,   ///< the triangles share more than the welded vertex or edge that they have in common
  Neighbour,  ///< they share exactly that: one welded vertex, or the edge between two
};

struct SelfSettings {
  SelfPairKind kind = SelfPairKind::Crossing;
  /// Stop after this many pairs. Which pairs these are is reproducible, and may depend on `volume`.
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  /// What prunes: changes the time, never which pairs there are.
  Volume volume = Volume::Aabb;
};

/// True if and only if two triangles of the mesh cross: their intersection is more than the welded
/// vertex or edge that they have in common. Duplicates cross, unless they are segments or points
/// that repeat a corner: these are no more than what they have in common. Exact for every finite
/// mesh.
bool self_intersects(const Mesh& mesh, Work* work = nullptr);
bool self_intersects(const Mesh& mesh, const QuerySettings& settings, Work* work = nullptr);

/// All pairs a < b of the kind, sorted.
TrianglePairs find_self_pairs(const Mesh& mesh, const SelfSettings& settings = {},
                              Work* work = nullptr);

}  // namespace graze
