#include "data/generator/generate.h"

#include <cstdio>
#include <string>

#include "data/generator/mesh_writers.h"
#include "data/generator/output_file.h"
#include "data/generator/parts/bolt.h"
#include "data/generator/parts/gear.h"
#include "data/generator/parts/link.h"
#include "data/generator/parts/nut.h"
#include "data/generator/parts/rock.h"
#include "data/generator/parts/terrain.h"
#include "data/generator/poses.h"

namespace graze::generator {
namespace {

constexpr double kMillimetre = 1e-3;

void write_poses(const std::filesystem::path& directory, const PoseList& list) {
  std::string text;
  for (const Eigen::Isometry3d& pose : list.poses) {
    for (int i = 0; i < 12; ++i) {
      char number[32];
      std::snprintf(number, sizeof number, "%.17g", pose.matrix()(i / 4, i % 4) + 0.0);
      text += number;
      text += i == 11 ? '\n' : ' ';
    }
  }
  write_file(directory / list.name, text);
}

}  // namespace

void generate(const std::filesystem::path& directory) {
  const std::filesystem::path meshes = directory / "meshes";
  const std::filesystem::path poses = directory / "poses";
  std::filesystem::create_directories(meshes);
  std::filesystem::create_directories(poses);
  write_obj(meshes / "bolt.obj", make_bolt().scaled(kMillimetre));
  write_binary_stl(meshes / "nut.stl", make_nut().scaled(kMillimetre));
  write_ply(meshes / "gear.ply", make_gear(kGear).scaled(kMillimetre));
  write_off(meshes / "pinion.off", make_gear(kPinion).scaled(kMillimetre));
  write_ply(meshes / "link.ply", make_link(kLink).scaled(kMillimetre),
            {.encoding = PlyEncoding::Ascii});
  write_ply(meshes / "rock.ply", make_rock(), {.encoding = PlyEncoding::BigEndian});
  write_ply(meshes / "terrain.ply", make_terrain(),
            {.coordinates = PlyCoordinates::Float, .indices = PlyIndices::Ushort});
  for (const PoseList& list : bolt_nut_poses())
    write_poses(poses, list);
  for (const PoseList& list : gear_pinion_poses())
    write_poses(poses, list);
  for (const PoseList& list : approach_poses(meshes))
    write_poses(poses, list);
}

}  // namespace graze::generator
