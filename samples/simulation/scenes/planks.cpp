#include "samples/simulation/scenes/planks.h"

#include "samples/simulation/scenes/parts.h"

namespace graze::samples {
namespace {

constexpr double kTable = 0.8;    // metres, the table's height
constexpr double kThick = 0.025;  // metres, half of a plank's thickness
const Eigen::Vector3d kPlank{1.2, 0.15, kThick};

/// Returns a block with its top at the table's height; as a mesh it has 48 triangles.
SceneBody table(Surface surface, double x) {
  return {.name = "table",
          .shape = as(surface, Box{{0.3, 0.4, kTable / 2}}, {.cells = 2}),
          .pose = at({x, 0, kTable / 2}),
          .hold = Hold::Fixed};
}

Scene tables(const std::string& name, Surface surface, std::vector<double> places) {
  Scene scene{.name = name + "." + name_of(surface), .bodies = {floor_of(surface)}};
  for (const double x : places)
    scene.bodies.push_back(table(surface, x));
  return scene;
}

void lay(Scene& scene, Surface surface, double x, int layer) {
  const double z = kTable + (2 * layer + 1) * kThick;
  scene.bodies.push_back({.name = "plank" + std::to_string(layer),
                          .shape = as(surface, Box{kPlank}, {.cells = 3}),
                          .pose = at({x, 0, z}),
                          .density = 600});
}

}  // namespace

std::vector<Scene> planks(Surface surface, Extent extent) {
  std::vector<Scene> scenes;
  const int layers = extent == Extent::Small ? 3 : 8;
  for (const int count : {1, layers}) {
    Scene& scene = scenes.emplace_back(
        tables(count == 1 ? "plank.trestles" : "planks.trestles", surface, {-0.8, 0.8}));
    for (int layer = 0; layer < count; ++layer)
      lay(scene, surface, 0, layer);
  }
  Scene& outward = scenes.emplace_back(tables("plank.overhang", surface, {0}));
  lay(outward, surface, 0.2, 0);
  // This is a plank of one kind on tables of the other.
  const Surface other = surface == Surface::Analytic ? Surface::Mesh : Surface::Analytic;
  Scene& across = scenes.emplace_back(tables("plank.other_tables", surface, {}));
  for (const double x : {-0.8, 0.8})
    across.bodies.push_back(table(other, x));
  lay(across, surface, 0, 0);
  if (extent == Extent::Large) {
    for (Scene& scene : scenes)
      scene.steps = 3000;
  }
  return scenes;
}

Scene tipping_plank(Surface surface, double beyond) {
  Scene scene = tables("plank.tips", surface, {0});
  scene.outcome = Outcome::Moves;
  lay(scene, surface, 0.3 + beyond, 0);
  return scene;
}

}  // namespace graze::samples
