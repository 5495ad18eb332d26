#include "samples/simulation/scenes/stacks.h"

#include <cmath>
#include <numbers>
#include <string>

#include "samples/simulation/scenes/parts.h"

namespace graze::samples {
namespace {

using Eigen::Vector3d;
constexpr double kQuarter = std::numbers::pi / 2;

/// Describes a body that stands on an end, so many metres from the middle to each end.
struct Standing {
  std::string name;
  Shape shape;
  double half_width, half_height;
};

std::vector<Standing> standing(Surface surface) {
  return {{"box", as(surface, Box{{0.2, 0.2, 0.15}}), 0.2, 0.15},
          {"cylinder", as(surface, Cylinder{0.2, 0.15}), 0.2, 0.15},
          {"hull", as(surface, drum(0.22, 0.15)), 0.22, 0.15}};
}

Scene empty(const std::string& name, Surface surface, Extent extent) {
  Scene scene{.name = name + "." + name_of(surface), .bodies = {floor_of(surface)}};
  if (extent == Extent::Large) scene.steps = 3000;
  return scene;
}

void put(Scene& scene, const std::string& name, const Shape& shape, const Pose& pose) {
  scene.bodies.push_back(
      {.name = name + std::to_string(scene.bodies.size()), .shape = shape, .pose = pose});
}

Scene stack(const Standing& kind, Surface surface, Extent extent) {
  Scene scene = empty("stack." + kind.name, surface, extent);
  const int count = extent == Extent::Small ? 5 : 10;
  for (int i = 0; i < count; ++i) {
    const double turn = 0.3 * i;  // so that corners lie within faces, too
    put(scene, kind.name, kind.shape,
        at({0, 0, (2 * i + 1) * kind.half_height}, turn, Vector3d::UnitZ()));
  }
  return scene;
}

Scene pyramid(const Standing& kind, Surface surface, Extent extent) {
  Scene scene = empty("pyramid." + kind.name, surface, extent);
  const int rows = extent == Extent::Small ? 4 : 8;
  const double apart = 2.2 * kind.half_width;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      const double x = apart * (i - 0.5 * (rows - row - 1));
      put(scene, kind.name, kind.shape, at({x, 0, (2 * row + 1) * kind.half_height}));
    }
  }
  return scene;
}

/// Returns bodies that lie on their sides between two walls, row on row like logs in a stack, each
/// in the hollow between two below. `radius` is from the axis to what lies on the floor.
Scene woodpile(const std::string& name, const Shape& shape, double radius, Surface surface,
               Extent extent) {
  Scene scene = empty("woodpile." + name, surface, extent);
  const int rows = extent == Extent::Small ? 3 : 6;
  const double rise = std::sqrt(3.0) * radius;
  for (const double side : {-1, 1}) {
    scene.bodies.push_back({.name = "wall",
                            .shape = as(surface, Box{{0.1, 0.7, 0.15}}),
                            .pose = at({side * (rows * radius + 0.1), 0, 0.15}),
                            .hold = Hold::Fixed});
  }
  // Their z axis lies along y, and their -x faces down.
  Eigen::Matrix3d lying;
  lying << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      Pose pose = at({(2 * i - (rows - row - 1)) * radius, 0, radius + row * rise});
      pose.linear() = lying;
      put(scene, name, shape, pose);
    }
  }
  return scene;
}

/// Returns bodies on which no other rests: side by side on the floor, and a cone on a box. A round
/// body lies on the middle of its -x side, where its mesh has a facet.
Scene singles(Surface surface, Extent extent) {
  Scene scene = empty("singles", surface, extent);
  const Fineness fine{.sectors = 32, .rings = 15};
  const double flat = surface == Surface::Analytic
                          ? 1
                          : std::cos(std::numbers::pi / 32) * std::cos(std::numbers::pi / 30);
  const Vector3d tipped = -Vector3d::UnitY();  // a quarter turn about it has -x below
  put(scene, "ellipsoid", as(surface, Ellipsoid{{0, 0, 0}, {0.1, 0.25, 0.3}}, fine),
      at({-1, 0, 0.1 * flat}, kQuarter, tipped));
  for (const double x : {0.0, 0.5}) {
    put(scene, "ball", as(surface, Sphere{{0, 0, 0}, 0.2}, fine),
        at({x, 1, 0.2 * flat}, kQuarter, tipped));
  }
  put(scene, "cone", as(surface, Cone{0.2, 0.2}), at({0, -1, 0.2}));
  put(scene, "box", as(surface, Box{{0.25, 0.25, 0.1}}), at({1, 0, 0.1}));
  put(scene, "cone", as(surface, Cone{0.2, 0.2}), at({1, 0, 0.4}));
  return scene;
}

/// Returns all kinds that have two flat ends, one on the other, shapes and meshes by turns.
Scene mixed_stack(Extent extent) {
  Scene scene{.name = "stack.mixed", .bodies = {floor_of(Surface::Mesh)}};
  const auto shapes = standing(Surface::Analytic), meshes = standing(Surface::Mesh);
  const int count = extent == Extent::Small ? 6 : 9;
  if (extent == Extent::Large) scene.steps = 3000;
  for (int i = 0; i < count; ++i) {
    const auto kind = static_cast<std::size_t>(i) % shapes.size();
    const Standing& body = i % 2 == 0 ? shapes[kind] : meshes[kind];
    put(scene, body.name, body.shape,
        at({0, 0, (2 * i + 1) * body.half_height}, 0.3 * i, Vector3d::UnitZ()));
  }
  return scene;
}

}  // namespace

std::vector<Scene> stacks(Surface surface, Extent extent) {
  std::vector<Scene> scenes;
  for (const Standing& kind : standing(surface)) {
    scenes.push_back(stack(kind, surface, extent));
    scenes.push_back(pyramid(kind, surface, extent));
  }
  // A mesh's flat strips are nearer to the axis than its edges.
  const double flat = surface == Surface::Analytic ? 1 : std::cos(std::numbers::pi / 24);
  scenes.push_back(
      woodpile("cylinder", as(surface, Cylinder{0.1, 0.5}), 0.1 * flat, surface, extent));
  scenes.push_back(
      woodpile("capsule", as(surface, Capsule{0.1, 0.5}), 0.1 * flat, surface, extent));
  scenes.push_back(singles(surface, extent));
  if (surface == Surface::Mesh) scenes.push_back(mixed_stack(extent));
  return scenes;
}

}  // namespace graze::samples
