#include "samples/simulation/scenes/terrains.h"

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/mesh_ray.h>

#include "samples/simulation/scenes/parts.h"

namespace graze::samples {
namespace {

double ground_at(const Mesh& mesh, double x, double y) {
  const double high = mesh.bounds().max.z() + 1;
  const auto hit = cast_ray(PlacedMeshView{mesh}, Ray{{x, y, high}, {0, 0, -1}});
  return hit ? high - hit->distance : 0;
}

}  // namespace

Scene terrain(Surface surface, Extent extent, const std::filesystem::path& data) {
  const Mesh ground = load_mesh(data / "meshes/terrain.ply");
  Scene scene{
      .name = std::string("terrain.") + name_of(surface), .bodies = {}, .outcome = Outcome::Moves};
  if (extent == Extent::Large) scene.steps = 1500;
  scene.bodies.push_back(
      {.name = "terrain", .shape = ground, .hold = Hold::Fixed, .friction = 0.8});
  const Shape kinds[] = {as(surface, Box{{0.15, 0.12, 0.1}}), as(surface, drum(0.15, 0.1)),
                         as(surface, Cylinder{0.12, 0.12}), as(surface, Capsule{0.08, 0.15})};
  const int side = extent == Extent::Small ? 6 : 20;
  const Eigen::Vector3d middle = 0.5 * (ground.bounds().min + ground.bounds().max);
  const double apart = 8.0 / side;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const double x = middle.x() + apart * (i - 0.5 * (side - 1));
      const double y = middle.y() + apart * (j - 0.5 * (side - 1));
      // The farthest of them reaches 0.23 m.
      scene.bodies.push_back(
          {.name = "body" + std::to_string(scene.bodies.size()),
           .shape = kinds[(i + j) % 4],
           .pose = at({x, y, ground_at(ground, x, y) + 0.23 + 0.3}, 0.7 * (i + 2 * j), {1, 2, 3}),
           .friction = 0.8});
    }
  }
  return scene;
}

}  // namespace graze::samples
