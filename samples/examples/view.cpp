// A page that shows bodies frame by frame: one file that any browser opens.

#include <graze/engine/view/view.h>
#include <graze/engine/world/world.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "samples/examples/example.h"

using examples::expect;

int main(int argc, char** argv) {
  if (argc != 2) return 2;  // a folder to write to
  const graze::Mesh cube = examples::cube(1);
  graze::View view({.title = "a cube comes down on a ball", .notes = {"each picture is a step"}});
  const graze::ViewBody box = view.add(cube, {.name = "cube"});
  const graze::ViewBody ball = view.add(graze::Sphere{{0.5, 0.5, -1}, 1}, {.name = "ball"});
  for (int step = 0; step < 5; ++step) {
    const graze::Pose pose = examples::at(0, 0, 1 - 0.25 * step);
    const graze::Sphere shape{{0.5, 0.5, -1}, 1};
    const graze::ShapeDistance gap =
        graze::distance({cube, pose}, {shape, graze::Pose::Identity()});
    const bool is_touching = gap.distance == 0;
    view.begin_frame({.label = "step " + std::to_string(step),
                      .state = is_touching ? graze::ViewState::Touching : graze::ViewState::Clear,
                      .facts = {{"distance", gap.distance, true}}});
    view.place(box, pose);
    view.place(ball, graze::Pose::Identity());
    if (!is_touching) view.add_gap(gap.point_a, gap.point_b, gap.distance);
  }
  const std::vector<std::uint32_t> below = {0, 1};  // the two triangles of the cube's lower side
  view.mark_triangles(box, below);
  view.add_contact({0.5, 0.5, 0}, {0, 0, -1}, 0);
  const std::vector<Eigen::Vector3d> edge = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  view.add_curve(edge);
  view.add_line({0.5, 0.5, 2}, {0.5, 0.5, 0});
  view.add_label({0.5, 0.5, 2}, "down");
  view.add_point({0.5, 0.5, 0});
  view.add_pair(box, ball);
  view.add_plane({.point = {0.5, 0.5, 0}, .normal = {0, 0, 1}, .half_extent = 1});
  const std::vector<graze::Obb> around = {{examples::at(0.5, 0.5, 0.5), {0.5, 0.5, 0.5}}};
  view.add_boxes(box, 0, around);
  view.add_note("the last step has all kinds of marks");

  graze::World world;
  world.add({cube, graze::Pose::Identity()});
  world.update();
  view.begin_frame({.label = "what a world draws of itself"});
  view.draw(world, {.has_boxes = true});

  const std::filesystem::path file = std::filesystem::path(argv[1]) / "cube.html";
  view.write(file);
  expect(std::filesystem::file_size(file) == view.page().size(), "the page is that file");
  std::filesystem::remove(file);
}
