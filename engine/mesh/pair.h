#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <graze/bvh/volume.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/touch.h>

namespace graze {

/// Triangle `a` of the first mesh and triangle `b` of the second.
struct TrianglePair {
  std::uint32_t a;
  std::uint32_t b;
  auto operator<=>(const TrianglePair&) const = default;
};

/// Whether a list holds all there is.
enum class Completeness { Complete, LimitReached };

/// Pairs in ascending order, without duplicates.
struct TrianglePairs {
  std::vector<TrianglePair> pairs;
  Completeness completeness = Completeness::Complete;

  std::size_t size() const { return pairs.size(); }
  bool empty() const { return pairs.empty(); }
  auto begin() const { return pairs.begin(); }
  auto end() const { return pairs.end(); }
  const TrianglePair& operator[](std::size_t index) const { return pairs[index]; }
};

/// How a query that answers yes or no goes about it.
struct QuerySettings {
  /// What prunes: changes the time, never the answer.
  Volume volume = Volume::Aabb;
  /// Which pairs of triangles count, for two meshes. What asks for no two meshes refuses any other
  /// policy than Include by InputError.
  Touch touch = Touch::Include;
};

struct PairSettings {
  /// Stop after this many pairs. Which pairs these are is reproducible, and may depend on `volume`.
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  /// What prunes: changes the time, never which pairs there are.
  Volume volume = Volume::Aabb;
  /// Which pairs count.
  Touch touch = Touch::Include;
};

/// True if and only if some placed triangle of A shares a point with some placed triangle of B
/// (laws 1 and 2), or under Touch::Exclude crosses() one. Surfaces only: a mesh wholly inside
/// another does not touch it. Stops at the first pair. Throws PoseError for a pose that is refused
/// by law 10 or by law 1.
bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work* work = nullptr);
bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, const QuerySettings& settings,
                Work* work = nullptr);

/// All such pairs, sorted. Throws as intersects() does.
TrianglePairs find_triangle_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                  const PairSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
