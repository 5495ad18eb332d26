#include "tests/benchmark/error/bundled_meshes.h"

#include <algorithm>

namespace graze::benchmark {

std::span<const MeshFiles> mesh_files() {
  static constexpr MeshFiles kFiles[] = {{"bolt-nut", "bolt.obj", "nut.stl"},
                                         {"gear-pinion", "gear.ply", "pinion.off"},
                                         {"link-link", "link.ply", "link.ply"},
                                         {"rock-rock", "rock.ply", "rock.ply"},
                                         {"terrain-rock", "terrain.ply", "rock.ply"}};
  return kFiles;
}

std::vector<std::filesystem::path> pose_files(const std::filesystem::path& folder,
                                              const std::string& name) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with(name + ".")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Pose> spread(const std::vector<Pose>& all, std::size_t count) {
  if (count >= all.size()) return all;
  std::vector<Pose> some;
  for (std::size_t i = 0; i < count; ++i)
    some.push_back(all[i * all.size() / count]);
  return some;
}

}  // namespace graze::benchmark
