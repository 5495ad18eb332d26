#pragma once

#include <graze/engine/files/output_file.h>
#include <graze/engine/mesh/voxels.h>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace graze::mesh_io {

/// The numbers of elements that a file will have.
struct BoxCounts {
  std::uint64_t corners;
  std::uint64_t quads;
};

/// A file of boxes in one format, to which corners and then quads are added.
class BoxFile {
 public:
  virtual ~BoxFile() = default;

  /// Adds a corner by the numbers of three planes of the grid.
  virtual void add_corner(const std::array<std::uint32_t, 3>& planes) = 0;

  /// Adds a quad by its corners, counted from 0.
  virtual void add_quad(const std::array<std::uint64_t, 4>& corners) = 0;
};

/// Begin a file. What it refers to must outlive it.
std::unique_ptr<BoxFile> begin_obj(files::OutputFile& file, const VoxelGrid& grid,
                                   BoxCounts counts);
std::unique_ptr<BoxFile> begin_ply(files::OutputFile& file, const VoxelGrid& grid,
                                   BoxCounts counts);

/// A kind of file for voxels: its names end with `extension`, in upper or lower case.
struct VoxelFormat {
  std::string_view extension;
  std::unique_ptr<BoxFile> (*begin)(files::OutputFile&, const VoxelGrid&, BoxCounts);
};

/// Returns the format of a file's name. Throws MeshError, naming the file, if the name ends like
/// none.
const VoxelFormat& voxel_format_of(const std::filesystem::path& path);

}  // namespace graze::mesh_io
