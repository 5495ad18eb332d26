#pragma once

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>

#include <cstdint>
#include <memory>

namespace graze {

class PairCache;

/// Holds what the last queries of one pair of meshes learned, for the next pose of a motion: how
/// far apart the meshes certainly were, triangles that touched or were nearest, and where a descent
/// over both trees ended, with how far each box was from the other there. It saves time and changes
/// no answer, however the meshes jump between two queries. It keeps handles of the two meshes;
/// asked about two others, or the same in the other order, it begins anew. One thread at a time may
/// use it. It grows with what a query walks: some 230 bytes for each eight pairs of boxes, and 360
/// to 750 for two leaves, up to 16 pairs of triangles.
class PairMemory {
 public:
  PairMemory();
  PairMemory(const PairMemory& other);
  PairMemory(PairMemory&& other) noexcept;
  PairMemory& operator=(const PairMemory& other);
  PairMemory& operator=(PairMemory&& other) noexcept;
  ~PairMemory();

  /// Return how many queries ended without a look at the trees: because the motion since some
  /// earlier one is less than how far apart the meshes then were, and because triangles that
  /// touched, or were within the clearance, still do.
  std::uint64_t still_apart() const;
  std::uint64_t still_touching() const;

 private:
  friend PairCache& recall(PairMemory& memory, const PlacedMeshView& mesh_a,
                           const PlacedMeshView& mesh_b);

  std::unique_ptr<PairCache> cache_;
};

/// Answers intersects(), beginning with what the memory holds and leaving in it what was learned,
/// always by PairVolume::WideObb.
bool intersects(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, PairMemory& memory,
                const MemoryQuerySettings& settings = {}, Work* work = nullptr);

/// Answers find_triangle_pairs() in the same way. Where there are more pairs than a limit, the
/// memory saves time only where nothing touches.
TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  PairMemory& memory, const MemoryPairSettings& settings = {},
                                  Work* work = nullptr);

/// Answers find_triangle_pairs() that several threads share in the same way. With more threads than
/// one the memory saves time only where nothing touches. It is a template as that one is.
template <typename = void>
TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  PairMemory& memory, const SharedPairSettings& settings,
                                  Work* work = nullptr);

/// Answers distance() in the same way, to the last bit. The settings' hint is looked at where the
/// memory has none of its own.
MeshDistance distance(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                      PairMemory& memory, const DistanceSettings& settings = {},
                      Work* work = nullptr);

/// Answers within() in the same way.
bool within(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, double clearance,
            PairMemory& memory, const DistanceSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
