#include "samples/simulation/scenes/machines.h"

#include <graze/engine/mesh/load_mesh.h>

#include <cmath>
#include <numbers>

#include "samples/simulation/scenes/parts.h"

namespace graze::samples {
namespace {

using std::numbers::pi;

/// Returns settings for bodies of a centimetre: overlaps of a hundredth of a millimetre stay.
SolverSettings small_settings() {
  return {.iterations = 4, .relaxations = 2, .slop = 5e-6, .push_speed = 0.1, .hertz = 60};
}

}  // namespace

Scene gears(Extent extent, const std::filesystem::path& data) {
  Scene scene{.name = "gears", .bodies = {}, .outcome = Outcome::Shown, .gravity = 0};
  scene.step = 1.0 / 300;
  scene.solver = small_settings();
  if (extent == Extent::Large) scene.steps = 3000;
  const double half_tooth = pi / kPinionTeeth;  // so that a tooth meets a gap
  scene.bodies.push_back({.name = "gear",
                          .shape = load_mesh(data / "meshes/gear.ply"),
                          .hold = Hold::Motor,
                          .density = 7850,
                          .friction = 0.1,
                          .spin = {0, 0, 2}});
  scene.bodies.push_back({.name = "pinion",
                          .shape = load_mesh(data / "meshes/pinion.off"),
                          .pose = at({0.05, 0, 0}, pi + half_tooth, Eigen::Vector3d::UnitZ()),
                          .hold = Hold::Axle,
                          .density = 7850,
                          .friction = 0.1});
  return scene;
}

Scene nut_on_bolt(double friction, Extent extent, const std::filesystem::path& data) {
  Scene scene{
      .name = friction < 0.1 ? "nut.slips" : "nut.locks", .bodies = {}, .outcome = Outcome::Shown};
  scene.step = 1.0 / 300;
  scene.solver = small_settings();
  if (extent == Extent::Small) scene.steps = 60;
  scene.bodies.push_back({.name = "bolt",
                          .shape = load_mesh(data / "meshes/bolt.obj"),
                          .hold = Hold::Fixed,
                          .density = 7850,
                          .friction = friction});
  scene.bodies.push_back({.name = "nut",
                          .shape = load_mesh(data / "meshes/nut.stl"),
                          .pose = at({0, 0, 8 * kPitch}),
                          .density = 7850,
                          .friction = friction});
  return scene;
}

}  // namespace graze::samples
