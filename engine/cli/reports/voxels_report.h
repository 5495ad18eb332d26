#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include <graze/engine/mesh/voxels.h>
#include <graze/engine/work.h>

namespace graze::cli {

/// Holds what `graze voxels` says of its result.
struct VoxelsReport {
  std::string mesh;
  std::string file;
  VoxelFill fill = VoxelFill::Surface;
  VoxelGrid grid{};
  std::size_t voxels = 0;
  Work work;
  std::chrono::duration<double> find_time{0};
  std::chrono::duration<double> write_time{0};
};

/// Returns one JSON object on one line.
std::string to_json(const VoxelsReport& report);

/// Returns aligned lines for people.
std::string to_text(const VoxelsReport& report);

}  // namespace graze::cli
