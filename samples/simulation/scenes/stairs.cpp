#include "samples/simulation/scenes/stairs.h"

#include <array>
#include <cmath>
#include <numbers>

#include "samples/simulation/scenes/parts.h"

namespace graze::samples {
namespace {

using Eigen::Vector3d;

constexpr int kSteps = 4;
constexpr double kTread = 0.5, kRise = 0.2, kHalfWidth = 1.0;  // metres

/// Builds stairs up along x from the origin. The mesh is one closed surface, the shapes are slabs
/// on the floor.
void build(Scene& scene, Surface surface) {
  if (surface == Surface::Analytic) {
    for (int i = 0; i < kSteps; ++i) {
      const double height = kRise * (i + 1), length = kTread * (kSteps - i);
      scene.bodies.push_back({.name = "step",
                              .shape = Box{{length / 2, kHalfWidth, height / 2}},
                              .pose = at({kTread * i + length / 2, 0, height / 2}),
                              .hold = Hold::Fixed,
                              .friction = 0.9});
    }
    return;
  }
  // The profile begins at the lowest corner at the back, so that a fan covers it.
  std::vector<std::array<double, 2>> profile{{kTread * kSteps, 0}};
  for (int i = kSteps - 1; i >= 0; --i) {
    profile.push_back({kTread * (i + 1), kRise * (i + 1)});
    profile.push_back({kTread * i, kRise * (i + 1)});
  }
  profile.push_back({0, 0});
  scene.bodies.push_back({.name = "stairs",
                          .shape = extruded(profile, kHalfWidth),
                          .hold = Hold::Fixed,
                          .friction = 0.9});
}

/// Returns a pose in the middle of a step, `up` metres above it and `from_riser` from the next
/// one's riser.
Pose on_step(int step, double from_riser, double up, double y) {
  return at({kTread * (step + 1) - from_riser, y, kRise * (step + 1) + up});
}

void put_body(Scene& scene, const std::string& name, const Shape& shape, const Pose& pose) {
  scene.bodies.push_back({.name = name, .shape = shape, .pose = pose, .friction = 0.9});
}

}  // namespace

std::vector<Scene> stairs(Surface surface, Extent extent) {
  std::vector<Scene> scenes;
  Scene& laden = scenes.emplace_back(Scene{.name = std::string("stairs.laden.") + name_of(surface),
                                           .bodies = {floor_of(surface)}});
  build(laden, surface);
  const int rows = extent == Extent::Small ? 1 : 3;
  for (int row = 0; row < rows; ++row) {
    const double y = 0.6 * (row - 0.5 * (rows - 1));
    put_body(laden, "box", as(surface, Box{{0.1, 0.2, 0.1}}), on_step(0, 0.3, 0.1, y));
    put_body(laden, "drum", as(surface, drum(0.2, 0.1)), on_step(1, 0.25, 0.1, y));
    put_body(laden, "cylinder", as(surface, Cylinder{0.15, 0.2}), on_step(2, 0.25, 0.2, y));
    // The cylinder's axis lies along the step, its -x faces down, and the riser touches another
    // side: 24 sectors have facets at every right angle.
    const double flat = surface == Surface::Analytic ? 1 : std::cos(std::numbers::pi / 24);
    Pose lying = on_step(0, 0.06 * flat, 0.06 * flat, y);
    lying.linear() << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    put_body(laden, "roll", as(surface, Cylinder{0.06, 0.25}), lying);
  }
  Scene& leaning = scenes.emplace_back(Scene{
      .name = std::string("stairs.plank.") + name_of(surface), .bodies = {floor_of(surface)}});
  build(leaning, surface);
  const double slope = std::atan2(kRise, kTread);
  const Vector3d up(-std::sin(slope), 0, std::cos(slope));
  const Vector3d middle_edge(kTread * (kSteps - 1) / 2.0, 0, kRise * (kSteps + 1) / 2.0);
  put_body(leaning, "plank", as(surface, Box{{1.1, 0.2, 0.03}}, {.cells = 3}),
           at(middle_edge + 0.03 * up, -slope, Vector3d::UnitY()));
  if (extent == Extent::Large) {
    for (Scene& scene : scenes)
      scene.steps = 3000;
  }
  return scenes;
}

}  // namespace graze::samples
