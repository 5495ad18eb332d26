#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/placed_mesh.h>

namespace graze::compare {

/// Poses of B drawn at random: any rotation, the middle of its bounds within the bounds of A grown
/// by half of B's size, so that hits and misses are both common. The same for the same seed on
/// every machine: no library's distributions, no libm beyond sqrt.
std::vector<Pose> random_poses(const PlacedMeshView& mesh_a, const Mesh& mesh_b, std::size_t count,
                               std::uint64_t seed);

/// Poses at which the two just touch, where engines go wrong: B comes from outside along a line
/// through A, and the last step before the first hit is halved until the translations of a hit and
/// of a miss are next to each other. Hits and misses in turn.
std::vector<Pose> grazing_poses(const PlacedMeshView& mesh_a, const Mesh& mesh_b, std::size_t count,
                                std::uint64_t seed);

}  // namespace graze::compare
