// A terrain as heights over a grid: a shape like any other, without a triangle in memory.

#include "samples/examples/example.h"

#include <vector>

using examples::at;
using examples::expect;

int main() {
  // 101 by 81 heights, half a metre apart, in centimetres; a hole where a shaft goes down.
  std::vector<std::uint16_t> heights(101 * 81, 200);
  std::vector<std::uint8_t> holes(100 * 80, 0), materials(100 * 80, 1);
  holes[40 * 100 + 50] = 1;
  materials[3] = 7;
  const graze::HeightField meadow(101, 81, std::span<const std::uint16_t>(heights),
                                  {.spacing_x = 0.5,
                                   .spacing_y = 0.5,
                                   .height_scale = 0.01,
                                   .height_offset = -1,
                                   .holes = holes,
                                   .materials = materials});
  expect(meadow.columns() == 101 && meadow.rows() == 81, "as many heights");
  expect(meadow.vertex(2, 0) == Eigen::Vector3d(1, 0, 1), "200 cm less a metre");
  expect(meadow.bounds().max.x() == 50 && meadow.triangle(0).b.x() == 0.5,
         "a cell is two triangles");
  expect(meadow.is_hole(50, 40) && meadow.material(3, 0) == 7, "what cells are");
  expect(meadow.bytes() < 4 * meadow.mesh().triangles().size(), "a mesh takes ten times as much");

  const graze::Shape ground = meadow;
  const graze::Shape ball = graze::Sphere{{0, 0, 0}, 0.3};
  expect(graze::intersects({ground}, {ball, at(10, 10, 1.2)}), "the ball is in the ground");
  expect(graze::distance({ground}, {ball, at(10, 10, 2.3)}).distance > 0.9, "or a metre above it");
  const auto hit = graze::cast_ray({ground}, {{10.2, 10.1, 9}, {0, 0, -1}});
  expect(hit && hit->distance == 8 && hit->triangle == 2 * (20 * 100 + 20), "seen from above");
  expect(!graze::cast_ray({ground}, {{25.2, 20.1, 9}, {0, 0, -1}}), "but through the hole");

  expect(hit->material == 1, "and of what it is made");
  const graze::Mesh bare = meadow.mesh();
  const std::vector<std::uint16_t> stone(bare.triangles().size(), 500);
  const graze::Mesh paved(bare.vertices(), bare.triangles(),
                          stone);  // triangles have materials, too
  expect(paved.materials()[0] == 500, "as they were given");

  graze::World world;
  const graze::BodyId terrain = world.add({ground}, {.kind = graze::BodyKind::Static});
  world.add({ball, at(10, 10, 1.2)});
  const graze::WorldUpdate update = world.update();
  expect(update.contacts.size() == 1, "a body lies on it");
  expect(update.contacts[0].manifold[0].material_a == 1, "and knows what it lies on");
  const std::vector<std::uint16_t> crater(10 * 10, 50);  // 1.5 metres deep
  const graze::HeightField dug =
      meadow.with_heights({.first_column = 16, .first_row = 16, .columns = 10, .rows = 10},
                          std::span<const std::uint16_t>(crater));
  world.set_shape(terrain, dug);
  expect(world.update().ended.size() == 1, "until somebody digs");

  const std::vector<float> slope = {0, 0, 1, 1};
  const graze::HeightField roof(2, 2, std::span<const float>(slope));
  const graze::HeightField steeper = roof.with_heights({0, 1, 2, 1}, std::vector<float>{2, 2});
  expect(steeper.bounds().max.z() == 2, "floats are heights, too");
}
