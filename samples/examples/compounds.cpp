// Several shapes in one body, or the voxels of a map: parts that are found by numbers, and come and
// go.

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

namespace {

/// What a robot has seen of a floor and a wall, as full voxels of 5 cm.
void what_is_occupied() {
  const graze::VoxelGrid grid{{-2, -2, -1}, 0.05, {80, 80, 40}};
  graze::VoxelMap map(grid);
  map.add_block({0, 0, 19}, {79, 79, 19});           // as a leaf of an octree is
  map.add(std::vector<graze::Voxel>{{40, 40, 20}});  // or one by one
  expect(map.size() == 6401 && map.contains({40, 40, 20}) && !map.empty(), "what is full");
  graze::World world;
  const graze::BodyId seen = world.add({graze::share(map), at(0, 0, 0)});
  const auto hit = world.cast_ray({{0.025, 0.025, 3}, {0, 0, -1}});
  const graze::VoxelMap* shared = graze::voxel_map_of(world.shape(seen));
  expect(shared->voxel(hit->part) == graze::Voxel{40, 40, 20}, "a ray names the voxel");
  const std::uint32_t part = map.part({40, 40, 20});
  expect(map.pose(part).translation().z() > 0 && map.box().as<graze::Box>() != nullptr, "its box");
  map.remove(std::vector<graze::Voxel>{{40, 40, 20}});
  map.remove_block({0, 0, 0}, {79, 39, 39});
  world.set_shape(seen, graze::share(map));
  expect(map.voxels().size() == 3200 && map.grid() == grid, "the rest of the floor");
  expect(world.find_touching({graze::Sphere{{0, -1, 0}, 0.2}}).empty(), "half of it is gone");
}

}  // namespace

int main() {
  what_is_occupied();
  graze::Compound table;
  const std::uint32_t top = table.add({graze::Box{{1, 1, 0.05}}, at(0, 0, 1)}, {.material = 2});
  for (const double x : {-0.9, 0.9})
    table.add({graze::Capsule{0.05, 0.4}, at(x, 0, 0.5)}, {.user_data = 7});
  graze::World world;
  const graze::BodyId body = world.add({graze::share(table), at(5, 0, 0)});
  const graze::BodyId ball = world.add({graze::Sphere{{0, 0, 0}, 0.5}, at(5, 0, 1.54)});
  const graze::WorldUpdate update = world.update();
  expect(update.begun.size() == 1 && update.contacts[0].manifold.part_a() == top, "on the top");
  graze::Manifold kept =
      update.contacts[0].manifold;  // the ball has no parts, and counts as its own
  expect(kept.part_b() == 0, "part 0");
  kept.set_parts(7, 7);  // what is kept may be called otherwise
  const graze::Compound* seen = graze::compound_of(world.shape(body));
  expect(seen->settings(top).material == 2 && seen->size() == 3, "what is known of the part");
  expect(world.cast_ray({{5, 0, 9}, {0, 0, -1}})->id == ball, "a ray meets the ball, not the part");
  expect(world.cast_ray({{4.5, 0, 9}, {0, 0, -1}})->part == top, "or the part");

  table.replace(top, {graze::Box{{1, 1, 0.01}}, at(0, 0, 1)});
  table.set_settings(top, {.material = 3});
  table.remove(table.parts().back());
  expect(table.contains(top) && table.part(top).pose.translation().z() == 1, "still there");
  world.set_shape(body, graze::share(table));  // parts came and went: the body stays
  expect(world.update().ended.size() == 1, "the thinner top does not reach the ball");
  const graze::Pose placed = graze::placed_part(world.pose(body), table.part(top).pose);
  expect(placed.translation().x() == 5, "where a part is");
}
