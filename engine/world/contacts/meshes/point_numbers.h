#pragma once

// Finds which ends of crossings are the same points. Private to engine/world.

#include <graze/engine/world/contacts/meshes/mesh_crossings.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// Numbers points: where a curve goes on, its points are ends of two crossings. Memory is kept from
/// one pair to the next.
class PointNumbers {
 public:
  /// Numbers the ends of the crossings, which must ascend by piece, in the order in which they are
  /// met first. So the numbers of a piece follow each other, and an end is new exactly if its
  /// number is.
  void number(std::span<MeshCrossing> crossings);

 private:
  struct Numbered {
    narrowphase::Vec3 point;
    std::uint32_t piece;
  };

  std::uint32_t number_of(const narrowphase::Vec3& point, std::uint32_t piece);

  std::vector<Numbered> points_;
  std::vector<std::uint32_t> table_;  ///< the numbers by hash, or kNone
};

}  // namespace graze
