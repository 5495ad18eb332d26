// What a recorder costs: worlds of which each stands there twice, with a recorder and without, and
// takes the same poses in turns. Prints a table and writes JSON.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/record/world_recorder.h>
#include <graze/engine/world/world.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"

namespace graze::benchmark {
namespace {

/// Bodies, and where each is in a step.
struct Scene {
  std::string name;
  std::vector<std::shared_ptr<const BodyShape>> shapes;  ///< of each body
  std::function<std::vector<Pose>(int)> poses;           ///< in a step, the same whenever asked
};

/// Of a cube of so many places, `spacing` apart.
Eigen::Vector3d place(std::size_t index, std::size_t count, double spacing) {
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  return spacing * Eigen::Vector3d(static_cast<double>(index % side),
                                   static_cast<double>(index / side % side),
                                   static_cast<double>(index / side / side));
}

/// Each body about its place, off by up to `way`, metres, and turned by up to `turn`, radians.
std::function<std::vector<Pose>(int)> shaken(std::vector<Eigen::Vector3d> places, double way,
                                             double turn) {
  return [places = std::move(places), way, turn](int step) {
    std::mt19937_64 random(static_cast<std::uint64_t>(step));
    std::uniform_real_distribution<double> off(-1, 1);
    std::vector<Pose> poses;
    for (const Eigen::Vector3d& at : places) {
      const Eigen::Vector3d axis{off(random), off(random), off(random)};
      Pose pose(Eigen::AngleAxisd(turn * off(random), axis.normalized()));
      pose.translation() = at + way * Eigen::Vector3d{off(random), off(random), off(random)};
      poses.push_back(pose);
    }
    return poses;
  };
}

Scene lattice(std::string name, const Shape& shape, std::size_t count, double spacing,
              double turn) {
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(place(i, count, spacing));
  return {std::move(name), std::vector(count, share(shape)), shaken(places, 0.02 * spacing, turn)};
}

Scene bolts(const std::string& meshes, std::size_t pairs) {
  const auto bolt = share(load_mesh(meshes + "/bolt.obj"));
  const auto nut = share(load_mesh(meshes + "/nut.stl"));
  std::vector<Eigen::Vector3d> places;
  Scene scene{.name = "bolts", .shapes = {}, .poses = {}};
  for (std::size_t i = 0; i < pairs; ++i) {
    scene.shapes.insert(scene.shapes.end(), {bolt, nut});
    places.push_back(place(i, pairs, 0.03));
    places.push_back(places.back() + Eigen::Vector3d(0, 0, 0.005));
  }
  scene.poses = shaken(places, 1e-4, 0.02);
  return scene;
}

Scene flight(std::size_t count) {
  Scene scene{
      .name = "flight", .shapes = std::vector(count, share(Sphere{{0, 0, 0}, 0.1})), .poses = {}};
  scene.poses = [count](int step) {
    const double t = step / 60.0;
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < count; ++i) {
      const double own = 1 + 0.001 * static_cast<double>(i);
      Pose pose(Eigen::AngleAxisd(3 * own * t, Eigen::Vector3d(2, 1, 2) / 3));
      pose.translation() = place(i, count, 0.15) +
                           Eigen::Vector3d(own * t, 0.5 * t, 2 * own * t - 0.5 * 9.81 * t * t);
      poses.push_back(pose);
    }
    return poses;
  };
  return scene;
}

/// A world of the scene.
struct Contestant {
  explicit Contestant(const Scene& scene) {
    const std::vector<Pose> poses = scene.poses(0);
    for (std::size_t i = 0; i < poses.size(); ++i)
      ids.push_back(world.add({scene.shapes[i], poses[i]}));
  }

  /// Nanoseconds.
  double step(const std::vector<Pose>& poses) {
    const ThreadClock clock;
    world.move(ids, poses);
    contacts = world.update().contacts.size();
    return clock.nanoseconds();
  }

  World world;
  std::vector<BodyId> ids;
  std::size_t contacts = 0;
};

/// Nanoseconds of all threads of this program.
double of_all_threads() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

nlohmann::json measure(const Scene& scene, int steps, const std::string& file) {
  Contestant alone(scene), recorded(scene);
  WorldRecorder recorder(recorded.world, std::filesystem::path(file),
                         {.seconds_per_update = 1.0 / 60});
  alone.world.update(), recorded.world.update();
  const std::uint64_t before = recorder.bytes();
  std::vector<double> times, recorded_times, ratios;
  const ThreadClock own;
  const double all = of_all_threads();
  for (int i = 1; i <= steps; ++i) {
    const std::vector<Pose> poses = scene.poses(i);
    const bool is_first = i % 2 == 0;
    double with = is_first ? recorded.step(poses) : 0;
    const double without = alone.step(poses);
    if (!is_first) with = recorded.step(poses);
    times.push_back(without), recorded_times.push_back(with), ratios.push_back(with / without);
  }
  recorder.updates();  // all are written then
  const double writing = (of_all_threads() - all - own.nanoseconds()) / steps;
  const double each = static_cast<double>(recorder.bytes() - before) / static_cast<double>(steps) /
                      static_cast<double>(scene.shapes.size());
  recorder.finish();
  const nlohmann::json row{{"scene", scene.name},
                           {"bodies", scene.shapes.size()},
                           {"contacts", alone.contacts},
                           {"step_us", 1e-3 * median(times)},
                           {"recorded_step_us", 1e-3 * median(recorded_times)},
                           {"ratio", median(ratios)},
                           {"writing_us", 1e-3 * writing},
                           {"bytes_each", each}};
  std::printf(
      "%-8s %6zu bodies %6zu manifolds  step %10.1f us  recorded %10.1f us  ratio %.3f"
      "  written in %8.1f us  %5.1f bytes a body\n",
      scene.name.c_str(), scene.shapes.size(), alone.contacts, 1e-3 * median(times),
      1e-3 * median(recorded_times), median(ratios), 1e-3 * writing, each);
  std::fflush(stdout);
  return row;
}

}  // namespace

int run(int argc, char** argv) {
  CLI::App app("What a recorder costs the world beside it");
  std::string output, meshes = "data/meshes";
  std::size_t bodies = 10000;
  int steps = 200;
  app.add_option("--output", output, "where JSON goes");
  app.add_option("--meshes", meshes, "the folder of bolt.obj and nut.stl");
  app.add_option("--bodies", bodies, "of the lattices; of bolts and nuts a fiftieth");
  app.add_option("--steps", steps, "of each world");
  CLI11_PARSE(app, argc, argv);
  const std::string file =
      (std::filesystem::temp_directory_path() / "graze-benchmark.recording").string();
  nlohmann::json rows = nlohmann::json::array();
  rows.push_back(measure(flight(bodies), steps, file));
  rows.push_back(measure(lattice("balls", Sphere{{0, 0, 0}, 0.5}, bodies, 1, 3), steps, file));
  rows.push_back(measure(lattice("boxes", Box{{0.49, 0.49, 0.49}}, bodies, 1, 0.1), steps, file));
  rows.push_back(measure(bolts(meshes, bodies / 100), steps, file));
  std::filesystem::remove(file);
  if (output.empty()) return 0;
  std::ofstream(output) << nlohmann::json{{"processor", processor_name()}, {"rows", rows}}.dump(1)
                        << "\n";
  return 0;
}

}  // namespace graze::benchmark

int main(int argc, char** argv) {
  return graze::benchmark::run(argc, argv);
}
