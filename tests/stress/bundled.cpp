#include "tests/stress/bundled.h"

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/pose_text.h>

#include <cmath>

namespace graze::stress {

std::vector<BundledPair> bundled_pairs(const std::filesystem::path& data) {
  const auto mesh = [&](const char* file) { return load_mesh(data / "meshes" / file); };
  const auto pose = [&](const char* file, std::size_t index) {
    return load_poses(data / "poses" / file).at(index);
  };
  const Mesh rock = mesh("rock.ply");
  Pose aside = Pose::Identity();
  aside.linear() = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  aside.translation() << 0.5, 0.03, 0.02;
  return {{"bolt-nut", mesh("bolt.obj"), mesh("nut.stl"), pose("bolt-nut.turning.txt", 7), 0, 2e-5},
          {"gear-pinion", mesh("gear.ply"), mesh("pinion.off"), pose("gear-pinion.mesh.txt", 3), 0,
           -1e-5},
          {"rock-rock", rock, rock, aside, 0, -1e-2}};
}

}  // namespace graze::stress
