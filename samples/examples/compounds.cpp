// Several shapes in one body: parts that are found by numbers, and come and go.

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

int main() {
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
