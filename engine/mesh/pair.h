#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <graze/bvh/volume.h>
#include <graze/engine/mesh/interior.h>
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
  Volume volume = Volume::Wide;
  /// Which pairs of triangles count, for two meshes. What asks for no two meshes refuses any other
  /// policy than Include by InputError.
  Touch touch = Touch::Include;
  /// Whether closed meshes are solid: a mesh, a box or a ball wholly inside one is then a hit.
  /// Needs Touch::Include. A mesh with itself has no inside to ask for and refuses Solid by
  /// InputError.
  Interior interior = Interior::Surface;
};

struct PairSettings {
  /// Stop after this many pairs. Which pairs these are is reproducible, and may depend on `volume`
  /// and, of deformed meshes, on what had been asked of the meshes that they were made of.
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  /// What prunes: changes the time, never which pairs there are.
  Volume volume = Volume::Wide;
  /// Which pairs count.
  Touch touch = Touch::Include;
  /// How many threads share this one query at most; 0: all that there are. Changes the time, never
  /// the result. Only a query by Volume::Wide without a limit is shared: which pairs come first is
  /// for one thread to say.
  int threads = 1;
};

/// True if and only if some placed triangle of A shares a point with some placed triangle of B
/// (laws 1 and 2), or under Touch::Exclude crosses() one. Surfaces only, unless Interior::Solid
/// says otherwise: a mesh wholly inside another does not touch it. Stops at the first pair; only
/// where there is none, one placed vertex of each connected part is asked whether the other mesh
/// encloses it, exactly. Throws PoseError for a pose that is refused by law 10 or by law 1,
/// InputError for settings that are none, and with Interior::Solid MeshError, which names the mesh
/// and its number of boundary edges, for one that is not closed.
bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work* work = nullptr);
bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, const QuerySettings& settings,
                Work* work = nullptr);

/// All such pairs, sorted. Throws as intersects() does.
TrianglePairs find_triangle_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                  const PairSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
