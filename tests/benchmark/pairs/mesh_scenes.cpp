#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/pose_text.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "tests/benchmark/common/pose_regimes.h"
#include "tests/benchmark/pairs/scene.h"

namespace graze::benchmark {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBundledPairs[][2] = {{"bolt.obj", "nut.stl"},
                                            {"gear.ply", "pinion.off"},
                                            {"link.ply", "link.ply"},
                                            {"rock.ply", "rock.ply"},
                                            {"terrain.ply", "rock.ply"}};

std::optional<fs::path> pose_file(const fs::path& mesh_file, const std::string& name) {
  const fs::path folder = mesh_file.parent_path();
  for (const fs::path& file : {folder / name, folder / ".." / "poses" / name}) {
    if (fs::exists(file)) return file.lexically_normal();
  }
  return std::nullopt;
}

std::vector<Pose> spread(const std::vector<Pose>& all, std::size_t count) {
  if (count >= all.size()) return all;
  std::vector<Pose> some;
  for (std::size_t i = 0; i < count; ++i)
    some.push_back(all[i * all.size() / count]);
  return some;
}

Scene scene_of(const fs::path& file_a, const fs::path& file_b, std::size_t poses) {
  Scene scene{"meshes",
              file_a.stem().string() + "-" + file_b.stem().string(),
              load_mesh(file_a),
              load_mesh(file_b),
              {}};
  for (const Regime regime : kRegimes) {
    const std::string name = scene.name + "." + name_of(regime) + ".txt";
    if (const auto file = pose_file(file_a, name)) {
      scene.regimes.push_back({name_of(regime), name, spread(load_poses(*file), poses)});
      continue;
    }
    scene.regimes.push_back({name_of(regime), "generated",
                             poses_in(regime, scene.mesh_a, scene.mesh_b, {.count = poses})});
  }
  return scene;
}

}  // namespace

double Scene::size() const {
  const auto half_diagonal = [](const Mesh& mesh) {
    return 0.5 * (mesh.bounds().max - mesh.bounds().min).norm();
  };
  return std::min(half_diagonal(mesh_a), half_diagonal(mesh_b));
}

std::vector<SceneMaker> mesh_scenes(const SceneSettings& settings) {
  std::vector<SceneMaker> scenes;
  const auto add = [&](const fs::path& a, const fs::path& b) {
    scenes.emplace_back([=, poses = settings.poses] { return scene_of(a, b, poses); });
  };
  for (const auto& [a, b] : kBundledPairs)
    add(fs::path(settings.data) / "meshes" / a, fs::path(settings.data) / "meshes" / b);
  for (const auto& [a, b] : settings.pairs)
    add(a, b);
  return scenes;
}

}  // namespace graze::benchmark
