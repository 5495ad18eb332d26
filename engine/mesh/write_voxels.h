#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include <graze/engine/mesh/voxels.h>

namespace graze {

/// The largest number of voxels that is written: more have too many triangles for a mesh.
inline constexpr std::uint64_t kMaxWrittenVoxels = 0x7fffffff / 12;

/// The settings of write_voxels().
struct VoxelWriteSettings {
  /// If set, called now and then with how many of how many corners and quads are written. What it
  /// throws ends the writing, and what was there before stays.
  std::function<void(std::uint64_t done, std::uint64_t total)> on_progress = {};
};

/// Writes each voxel as a closed box of six quads, wound counter-clockwise seen from outside, to an
/// OBJ file (text, coordinates with 17 digits) or a PLY file (binary, little-endian, doubles),
/// chosen by the file name's ending in upper or lower case. Boxes share the corners that they have
/// in common, bit for bit those of VoxelGrid::box(). load_mesh() reads either again, as 12
/// triangles a voxel.
///
/// Throws MeshError, naming the file, for another ending, for more voxels or corners than a mesh
/// can have, or if the file cannot be written. A regular file is written beside its place and then
/// takes it in one step: whatever fails, an old file stays as it was. What a link leads to is
/// replaced, and the link stays; pipes and devices are written through. Throws InputError for no
/// voxels, a grid that check() refuses, and voxels that are not in ascending order, each once, and
/// within the grid. It takes a fraction of the memory of the voxels.
void write_voxels(const std::filesystem::path& path, const Voxels& voxels,
                  const VoxelWriteSettings& settings = {});

}  // namespace graze
