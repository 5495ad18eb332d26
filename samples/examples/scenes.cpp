// Scenes: bodies and how they move by themselves, as a file says, and a loop that steps them.

#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>

#include <filesystem>
#include <fstream>

#include "samples/examples/example.h"

using examples::expect;

namespace {

constexpr const char* kText = R"({
  "graze_scene": 1,
  "step": 0.25, "steps": 8,
  "shapes": [{"name": "ball", "sphere": {"radius": 0.5}}],
  "bodies": [
    {"name": "still", "parts": [{"shape": "ball"}, {"shape": "ball", "pose": {"position": [-0.5, 0, 0]}}]},
    {"name": "mover", "shape": "ball", "pose": {"position": [3, 0, 0]}, "path": {"velocity": [-2, 0, 0]}}
  ]
})";

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;  // a folder to write to
  const graze::Scene scene = graze::parse_scene(kText, "our scene");
  const std::filesystem::path file = std::filesystem::path(argv[1]) / "scene.json";
  std::ofstream(file) << kText;
  expect(graze::read_scene(file).bodies.size() == scene.bodies.size(), "the same from a file");
  std::filesystem::remove(file);

  expect(graze::pose_at(scene.bodies[1], 1).translation().x() == 1, "where a body is at a time");
  const auto still = graze::body_shape(scene, scene.bodies[0]);
  expect(graze::compound_of(*still)->size() == 2, "a body of two parts, as a world takes it");
  expect(graze::meeting_pairs(scene).size() == 1, "who can meet whom");
  graze::check_paths(scene, 10);  // throws PoseError if a path leads out of the world

  graze::Simulation simulation(scene, {.world = {.threads = 1}});
  while (simulation.advance().begun.empty())
    expect(simulation.steps() < scene.steps, "they meet before the end");
  expect(simulation.time() == 1, "after a second the two touch");
  expect(simulation.time_of(4) == simulation.time(), "which is the fourth step");
  expect(simulation.world().pairs().size() == 1, "as its world says");
}
