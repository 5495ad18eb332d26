#pragma once

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/pose_text.h>

#include <filesystem>
#include <string>
#include <vector>

namespace graze::tests {

inline Pose shifted(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() << x, y, z;
  return pose;
}

/// Two bundled meshes and poses of the second, by the name of the poses: "rock-rock.touch".
struct BundledPair {
  explicit BundledPair(const std::string& name)
      : mesh_a(load(name.substr(0, name.find('-')))),
        mesh_b(load(name.substr(name.find('-') + 1, name.find('.') - name.find('-') - 1))),
        poses(load_poses(std::filesystem::path(GRAZE_DATA_DIR) / "poses" / (name + ".txt"))) {}

  Mesh mesh_a;
  Mesh mesh_b;
  std::vector<Pose> poses;

 private:
  static Mesh load(const std::string& part) {
    const char* ending = part == "bolt"     ? ".obj"
                         : part == "nut"    ? ".stl"
                         : part == "pinion" ? ".off"
                                            : ".ply";
    return load_mesh(std::filesystem::path(GRAZE_DATA_DIR) / "meshes" / (part + ending));
  }
};

}  // namespace graze::tests
