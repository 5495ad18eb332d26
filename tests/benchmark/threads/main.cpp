// What more threads bring: batches of poses, and one query shared by threads. Clocks on the wall,
// for that is what threads are to save.

#include <graze/bvh/error.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/threads/measure.h"

namespace graze::benchmark {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string output;
  std::string only_scene;
  std::vector<int> threads = {1, 2};
  int rounds = 15;
  SceneSettings scenes;
};

void print(const std::string& scene, const std::string& regime, Sharing sharing,
           const ThreadTimes& times) {
  std::printf("%-18s %-6s %-16s", scene.c_str(), regime.c_str(), name_of(sharing));
  for (const double microseconds : times.microseconds)
    std::printf(" %9.4g (%4.2f)", microseconds, times.microseconds[0] / microseconds);
  std::printf(" %5zu wrong\n", times.wrong);
  std::fflush(stdout);
}

Json measured(const Scene& scene, const Options& options, std::size_t& wrong) {
  Json rows = Json::array();
  for (const RegimePoses& regime : scene.regimes) {
    if (regime.name == "far") continue;  // one test of boxes each
    for (const Sharing sharing : kSharings) {
      if (sharing == Sharing::OneQuery && regime.name != "deep") continue;  // ends too soon
      const ThreadTimes times =
          measure_threads(scene, regime, sharing, options.threads, options.rounds);
      wrong += times.wrong;
      print(scene.name, regime.name, sharing, times);
      rows.push_back({{"regime", regime.name},
                      {"shared", name_of(sharing)},
                      {"poses", regime.poses.size()},
                      {"pairs", times.pairs},
                      {"microseconds", times.microseconds},
                      {"wrong", times.wrong}});
    }
  }
  return {{"scene", scene.name},
          {"triangles", {scene.mesh_a.triangles().size(), scene.mesh_b.triangles().size()}},
          {"rows", rows}};
}

std::size_t run(const Options& options) {
  Json document{{"processor", processor_name()},
                {"cores", std::thread::hardware_concurrency()},
                {"rounds", options.rounds},
                {"threads", options.threads},
                {"scenes", Json::array()}};
  std::printf("microseconds a query, and how many times faster than with the first number of:");
  for (const int threads : options.threads)
    std::printf(" %d", threads);
  std::printf(" threads\n");
  std::size_t wrong = 0;
  for (const auto& makers : {mesh_scenes(options.scenes), scaling_scenes(options.scenes)}) {
    for (const SceneMaker& make_scene : makers) {
      const Scene scene = make_scene();
      if (options.only_scene.empty() || options.only_scene == scene.name)
        document["scenes"].push_back(measured(scene, options, wrong));
    }
  }
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
  options.scenes.poses = 200;
  options.scenes.most_triangles = 300000;
  CLI::App program("Queries by several threads beside the same by one: measurements as JSON");
  program.add_option("--data", options.scenes.data, "folder of the bundled geometry")->required();
  program.add_option("--output", options.output, "JSON file to write")->required();
  program.add_option(
      "--pair", options.scenes.pairs,
      "two more meshes, A B, with poses in A-B.REGIME.txt beside A if there are any; "
      "may be repeated");
  program.add_option("--scene", options.only_scene, "one alone, such as bolt-nut");
  program
      .add_option("--threads", options.threads,
                  "numbers of threads, the first to compare with (default 1 2)")
      ->check(CLI::Range(1, 1024));
  program.add_option("--poses", options.scenes.poses, "in each regime (default 200)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10000}));
  program
      .add_option("--triangles", options.scenes.most_triangles,
                  "of the finest refined mesh (default 300000)")
      ->check(CLI::Range(std::size_t{1000}, std::size_t{10000000}));
  program.add_option("--rounds", options.rounds, "each asks in all poses (default 15)")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(program, argc, argv);
  try {
    const std::size_t wrong = graze::benchmark::run(options);
    if (wrong > 0) std::fprintf(stderr, "graze_benchmark_threads: %zu answers differ\n", wrong);
    return wrong > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_benchmark_threads: %s\n", error.what());
    return 2;
  }
}
