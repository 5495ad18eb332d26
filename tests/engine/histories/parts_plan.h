#pragma once

// Bodies of several parts as data, of which the worlds and the oracle each make their own.

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/voxel_grid.h>
#include <graze/engine/world/body.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/engine/histories/history.h"

namespace graze::tests {

/// Parts of a compound in their order, or full voxels of a grid.
struct PartsPlan {
  struct Part {
    std::uint32_t shape = 0;  // in the palette
    Pose pose = Pose::Identity();
    std::optional<Filter> filter = {};
    std::uint32_t label = 0;  // as user data and as material
  };
  std::vector<Part> parts = {};
  std::optional<VoxelGrid> grid = {};
  std::vector<Voxel> voxels = {};
  std::uint32_t voxel_shape = 0;  // in the palette: half an edge along each axis
};

/// What a body's number stands for from the size of the palette on; none but for Setting::Parts.
std::vector<PartsPlan> plans_of(Setting setting);

/// A body of parts never has more of them than this, but for a plan that begins with more.
inline constexpr std::size_t kMostParts = 26;
inline constexpr std::size_t kMostVoxels = 90;

/// What the operation says of its part.
std::optional<Filter> part_filter(const Operation& operation);
bool is_about_a_part(Verb verb);  // or about voxels

}  // namespace graze::tests
