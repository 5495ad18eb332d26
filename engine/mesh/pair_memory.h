#pragma once

#include <graze/engine/mesh/pair.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace graze {

/// What the last queries of one pair of meshes learned, for the next pose of a motion: triangles
/// that touched, and how far apart the meshes certainly were. It saves time and changes no answer,
/// however the meshes jump between two queries. It keeps handles of the two meshes; asked about two
/// others, or the same in the other order, it begins anew. One thread at a time may use it.
class PairMemory {
 public:
  /// Queries that ended without a look at the trees: because the motion since some earlier one is
  /// less than how far apart the meshes then were, and because triangles that touched still do.
  std::uint64_t still_apart() const { return still_apart_; }
  std::uint64_t still_touching() const { return still_touching_; }

 private:
  friend class MemoryQuery;

  /// The mesh B in the frame of A, in common units, when last a walk proved a gap.
  struct Placing {
    double rotation[3][3];
    double translation[3];
  };

  static constexpr std::size_t kMostPairs = 8;

  std::optional<Mesh> mesh_a_;
  std::optional<Mesh> mesh_b_;
  std::array<TrianglePair, kMostPairs> pairs_{};  // that touched, the last to do so first
  std::size_t pair_count_ = 0;
  Placing proven_{};
  double gap_ = 0;  // at proven_, common units; 0: nothing is proven
  Placing last_{};  // of the last query
  bool has_last_ = false;
  double steps_ahead_ = 8;  // how many steps a proof is to last
  int pause_ = 0;           // queries until the next attempt at one
  int next_pause_ = 1;
  std::uint64_t still_apart_ = 0;
  std::uint64_t still_touching_ = 0;
};

/// intersects(), beginning with what the memory holds and leaving in it what was learned. Volumes
/// other than Volume::Wide are refused by InputError. Allocates nothing once the trees are built.
bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, PairMemory& memory,
                const QuerySettings& settings = {}, Work* work = nullptr);

/// find_triangle_pairs(), likewise: it saves where nothing touches.
TrianglePairs find_triangle_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                  PairMemory& memory, const PairSettings& settings = {},
                                  Work* work = nullptr);

}  // namespace graze
