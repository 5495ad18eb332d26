#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>

#include <typeinfo>

#include "tests/engine/floating_point/questions.h"
#include "tests/files/temporary_directory.h"

namespace graze::tests {
namespace {

constexpr const char* kScene = R"({"graze_scene": 1, "units": {"length": "mm", "angle": "degree"},
  "step": 0.01, "steps": 3,
  "shapes": [{"name": "ball", "sphere": {"radius": 20.1}},
             {"name": "box", "box": {"half_extents": [10.1, 20.3, 30.7]}}],
  "bodies": [
    {"name": "still", "shape": "box"},
    {"name": "turning", "shape": "box", "path": {"velocity": [0.1, 0, -1.3], "axis": [0.6, 0, 0.8],
     "rate": 33.3}},
    {"name": "keyed", "shape": "ball", "path": {"keys": [
      {"time": 0, "pose": {"position": [1e-320, 0, 0]}},
      {"time": 1, "pose": {"position": [31.7, 0.1, 1], "axis": [1, 0, 0], "angle": 33}}]}}]})";

constexpr const char* kMesh =
    "v 5e-324 1e-310 0.1\nv 1.7976931348623157e308 4.9e-324 -2.2250738585072011e-308\n"
    "v 0.30000000000000004 2.5e-323 1\nf 1 2 3\n";

void ask_scene(const Inputs&, Words& words) {
  const Scene scene = parse_scene(kScene, "scene");
  check_paths(scene, 0.5);
  Simulation simulation(scene);
  for (int step = 0; step < 4; ++step) {
    const WorldUpdate update = simulation.advance();
    words.add(std::uint64_t{update.begun.size()});
    for (const BodyContact& contact : update.contacts) {
      for (const ShapeContact& each : contact.manifold)
        words.add(each.point), words.add(each.depth);
    }
  }
  for (const SceneBody& body : scene.bodies)
    words.add(pose_at(body, 0.37));
}

void ask_case(const Inputs& in, Words& words) {
  const Mesh a(in.vertices_a, in.triangles_a), b(in.vertices_b, in.triangles_b);
  const PlacedMesh placed_a{a, in.pose_a}, placed_b{b, in.pose_b};
  const Case query = to_case(placed_a, placed_b, distance(placed_a, placed_b));
  const std::string text = to_json(query);
  words.add(text), words.add(to_json(parse_case(text, "case")));
  words.add(to_plain_json(answer_of(distance(placed_a, placed_b))));
  MeshDistance other = distance(placed_a, placed_b);
  words.add(is_same(answer_of(other), query.answer.value()));
  other.distance = in.clearance;
  words.add(is_same(answer_of(other), query.answer.value()));
}

}  // namespace

std::vector<Question> file_questions() {
  return {
      {"poses as text",
       [](const Inputs& in, Words& words) { words.add(parse_pose(in.pose_text, "pose")); }},
      {"meshes of files",
       [](const Inputs&, Words& words) {
         static const TemporaryDirectory folder;
         static const std::string path = folder.write("mesh.obj", kMesh);
         const Mesh mesh = load_mesh(path);
         for (const Eigen::Vector3d& vertex : mesh.vertices())
           words.add(vertex);
       }},
      {"scenes", ask_scene},
      {"cases", ask_case},
  };
}

std::vector<Question> all_questions(int threads) {
  std::vector<Question> all;
  for (const auto& list : {triangle_questions(), volume_questions(), mesh_questions(threads),
                           world_questions(threads), file_questions()})
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

std::vector<std::uint64_t> answer(const Question& question, const Inputs& inputs) {
  Words words;
  try {
    question.ask(inputs, words);
  } catch (const Error& error) {
    words.add(std::string(error.what()));
  }
  return words.list();
}

}  // namespace graze::tests
