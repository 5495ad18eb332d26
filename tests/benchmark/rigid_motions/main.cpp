// Rigid motions of two meshes: edges that are free and that hit, beside static queries and
// advancement; a nut that turns on its bolt, and gears that roll; and convex shapes beside FCL.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/pose_text.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/rigid_motions/edges.h"
#include "tests/benchmark/rigid_motions/shapes.h"

namespace graze::benchmark {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string output;
  SceneSettings scenes;
  EdgeSettings edges;
  int shape_motions = 40;
};

Json to_json(const EdgeTimes& times) {
  if (times.first_contact.empty()) return {{"edges", 0}};
  return {{"edges", times.first_contact.size()},
          {"microseconds", median(times.first_contact)},
          {"other_microseconds", median(times.other)}};
}

void print(const char* what, const Json& row) {
  if (row["edges"] == 0) return;
  std::printf("  %-5s %4d edges %10.1f us, %10.1f us\n", what, row["edges"].get<int>(),
              row["microseconds"].get<double>(), row["other_microseconds"].get<double>());
}

Json measured(const Scene& scene, const RegimePoses& regime, const EdgeSettings& settings,
              std::size_t& wrong) {
  const EdgeResult result = measure_edges(scene, regime, settings);
  wrong += result.wrong;
  Json row{{"scene", scene.name},        {"regime", regime.name}, {"free", to_json(result.free)},
           {"hit", to_json(result.hit)}, {"close", result.close}, {"wrong", result.wrong}};
  std::printf("%s %s: %zu wrong\n", scene.name.c_str(), regime.name.c_str(), result.wrong);
  print("free", row["free"]);
  print("hit", row["hit"]);
  return row;
}

/// A motion of bundled parts that is free, in milliseconds.
Json free_motion(const char* name, const Mesh& a, const RigidMotion& motion_a, const Mesh& b,
                 const RigidMotion& motion_b, std::size_t& wrong) {
  std::vector<double> times;
  for (int i = 0; i < 3; ++i) {
    const ThreadClock clock;
    wrong += !is_free({a, motion_a}, {b, motion_b});
    times.push_back(clock.nanoseconds() / 1e6);
  }
  std::printf("%-28s %10.1f ms\n", name, median(times));
  return {{"motion", name}, {"milliseconds", median(times)}};
}

Json measured_parts(const std::string& data, std::size_t& wrong) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const Mesh bolt = load_mesh(data + "/meshes/bolt.obj"), nut = load_mesh(data + "/meshes/nut.stl");
  const std::vector<Pose> turning = load_poses(data + "/poses/bolt-nut.turning.txt");
  const Eigen::Vector3d axis = RigidMotion::between(turning[0], turning[1]).axis();
  const RigidMotion nut_turns =
      RigidMotion::screw(turning[0], {.axis = axis, .angle = 0.45 * kTurn, .pitch = 1.25e-3});
  const Mesh gear = load_mesh(data + "/meshes/gear.ply");
  const Mesh pinion = load_mesh(data + "/meshes/pinion.off");
  const Pose start = load_poses(data + "/poses/gear-pinion.mesh.txt").front();
  const RigidMotion rest(Pose::Identity());
  return {free_motion("nut, 0.45 turns", bolt, rest, nut, nut_turns, wrong),
          free_motion(
              "gears, a pitch", gear, RigidMotion(Pose::Identity(), {.angle = -kTurn / 31}), pinion,
              RigidMotion(start, {.centre = start.translation(), .angle = kTurn / 19}), wrong)};
}

/// How many answers were wrong.
std::size_t run(const Options& options) {
  std::size_t wrong = 0;
  Json document{{"processor", processor_name()}, {"edges", Json::array()}};
  for (const SceneMaker& make_scene : mesh_scenes(options.scenes)) {
    const Scene scene = make_scene();
    for (const RegimePoses& regime : scene.regimes) {
      if (regime.name == "far" || regime.name == "near")
        document["edges"].push_back(measured(scene, regime, options.edges, wrong));
    }
  }
  document["parts"] = measured_parts(options.scenes.data, wrong);
  document["shapes"] = measure_shape_motions(options.shape_motions, wrong);
  std::ofstream file(options.output);
  file << document.dump(1) << "\n";
  file.close();
  if (!file) throw Error(options.output + ": cannot be written");
  return wrong;
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  graze::benchmark::Options options;
  CLI::App program("Rigid motions of two meshes: measurements as JSON");
  program.add_option("--data", options.scenes.data, "folder of the bundled geometry")->required();
  program.add_option("--output", options.output, "JSON file to write")->required();
  program.add_option("--edges", options.edges.count, "in each regime (default 200)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}));
  program.add_option(
      "--reach", options.edges.reach,
      "how far B goes along each axis at most, as a share of the smaller mesh's size");
  program.add_option("--turn", options.edges.turn, "how far it turns at most, radians");
  program
      .add_option("--shape-motions", options.shape_motions,
                  "of each pair of kinds of convex shapes (default 40)")
      ->check(CLI::Range(1, 100000));
  CLI11_PARSE(program, argc, argv);
  try {
    const std::size_t wrong = graze::benchmark::run(options);
    if (wrong > 0) std::fprintf(stderr, "graze_benchmark_rigid_motions: %zu wrong\n", wrong);
    return wrong > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_benchmark_rigid_motions: %s\n", error.what());
    return 2;
  }
}
