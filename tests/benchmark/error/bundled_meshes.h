#pragma once

#include <graze/bvh/pose.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace graze::benchmark {

struct MeshFiles {
  const char* name;  ///< what the files of poses begin with
  const char* a;
  const char* b;
};

/// The bundled pairs of meshes.
std::span<const MeshFiles> mesh_files();

/// The files of poses in a folder whose names begin with `name` and a dot, sorted.
std::vector<std::filesystem::path> pose_files(const std::filesystem::path& folder,
                                              const std::string& name);

/// At most `count` of the poses, spread evenly.
std::vector<Pose> spread(const std::vector<Pose>& all, std::size_t count);

}  // namespace graze::benchmark
