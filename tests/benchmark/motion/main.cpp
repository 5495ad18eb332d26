// Two meshes in coherent motion: what a PairMemory saves, regime by regime, and whether it changes
// an answer.

#include <graze/bvh/error.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/motion/means.h"
#include "tests/benchmark/motion/measure.h"

namespace graze::benchmark {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string output;
  std::string only_scene;
  std::string only;
  std::string only_question;
  SceneSettings scenes;
  PathSettings paths;
  MotionSettings motion;
};

double rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return std::stod(text);
}

Json to_json(const Work& work, std::size_t queries) {
  const auto mean = [&](std::uint64_t count) {
    return rounded(static_cast<double>(count) / static_cast<double>(queries));
  };
  return {{"volume_tests", mean(work.volume_tests)},
          {"filter_tests", mean(work.filter_tests)},
          {"triangle_tests", mean(work.triangle_tests)},
          {"exact_tests", mean(work.exact_tests)},
          {"skipped_by_memory", mean(work.skipped_by_memory)}};
}

/// Times are means over the queries of all paths, some of which end early; `saved` is the share of
/// the whole time, `median_saved` that of the path in the middle.
Json to_json(const MotionResult& result) {
  double cold = 0;
  double remembering = 0;
  std::vector<double> saved;
  for (const PathTimes& path : result.paths) {
    const auto queries = static_cast<double>(path.queries);
    cold += queries * path.cold_microseconds;
    remembering += queries * path.remembering_microseconds;
    saved.push_back(1 - path.remembering_microseconds / path.cold_microseconds);
  }
  const auto count = static_cast<double>(result.queries);
  return {{"question", name_of(result.question)},
          {"queries", result.queries},
          {"wrong", result.wrong},
          {"microseconds", rounded(cold / count)},
          {"remembering_microseconds", rounded(remembering / count)},
          {"saved", rounded(1 - remembering / cold)},
          {"median_saved", rounded(median(saved))},
          {"work", to_json(result.cold, result.queries)},
          {"remembering_work", to_json(result.remembering, result.queries)}};
}

void print(const std::string& scene, const std::string& regime, const Json& row) {
  std::printf("%-16s %-6s %-9s %10.4g %10.4g %7.0f %% %7.0f %% %5d wrong\n", scene.c_str(),
              regime.c_str(), row["question"].get<std::string>().c_str(),
              row["microseconds"].get<double>(), row["remembering_microseconds"].get<double>(),
              100 * row["saved"].get<double>(), 100 * row["median_saved"].get<double>(),
              row["wrong"].get<int>());
  std::fflush(stdout);
}

Json measured(const Scene& scene, const Options& options, MotionMeans& means, std::size_t& wrong) {
  Json regimes = Json::array();
  for (const RegimePoses& regime : scene.regimes) {
    if (!options.only.empty() && options.only != regime.name) continue;
    const std::vector<Path> paths = paths_in(scene, regime, options.paths);
    Json answers = Json::array();
    for (const Question question : kQuestions) {
      if (!options.only_question.empty() && options.only_question != name_of(question)) continue;
      const MotionResult result = measure_motion(scene, paths, question, options.motion);
      wrong += result.wrong;
      answers.push_back(to_json(result));
      print(scene.name, regime.name, answers.back());
      means.add(name_of(question), regime.name, answers.back()["microseconds"],
                answers.back()["remembering_microseconds"]);
    }
    regimes.push_back({{"regime", regime.name}, {"paths", paths.size()}, {"answers", answers}});
  }
  return {{"scene", scene.name},
          {"triangles", {scene.mesh_a.triangles().size(), scene.mesh_b.triangles().size()}},
          {"regimes", regimes}};
}

/// How many answers were wrong.
std::size_t run(const Options& options) {
  Json document{{"processor", processor_name()},
                {"step", options.paths.step},
                {"turn", options.paths.turn},
                {"clearance", options.motion.clearance},
                {"repetitions", options.motion.repetitions},
                {"scenes", Json::array()}};
  std::printf("%-16s %-6s %-9s %10s %10s %9s %9s\n", "scene", "regime", "question", "us, cold",
              "with memory", "saved", "median");
  std::size_t wrong = 0;
  MotionMeans means;
  const auto add = [&](const Scene& scene) {
    if (options.only_scene.empty() || options.only_scene == scene.name)
      document["scenes"].push_back(measured(scene, options, means, wrong));
  };
  for (const SceneMaker& make_scene : mesh_scenes(options.scenes))
    add(make_scene());
  means.print();
  document["saved_in_geometric_mean"] = means.to_json();
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
  CLI::App program("Meshes in coherent motion, with a memory and without: measurements as JSON");
  program.add_option("--data", options.scenes.data, "folder of the bundled geometry")->required();
  program.add_option("--output", options.output, "JSON file to write")->required();
  program.add_option(
      "--pair", options.scenes.pairs,
      "two more meshes, A B, with poses in A-B.REGIME.txt beside A if there are any; "
      "may be repeated");
  program.add_option("--scene", options.only_scene, "one alone, such as bolt-nut");
  program.add_option("--regime", options.only, "far, near, touch or deep alone");
  program.add_option("--question", options.only_question, "any, pairs, distance or within alone");
  program.add_option("--paths", options.paths.count, "in each regime (default 4)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10000}));
  program.add_option("--steps", options.paths.steps, "of each path (default 100)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}));
  program.add_option(
      "--step", options.paths.step,
      "how far B goes in each, as a share of the smaller mesh's size (default 0.001)");
  program.add_option("--turn", options.paths.turn,
                     "how far its farthest points turn, likewise (default 0.0005)");
  program.add_option("--clearance", options.motion.clearance,
                     "of the question within, likewise (default 0.01)");
  program.add_option("--repetitions", options.motion.repetitions, "of each path (default 5)")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(program, argc, argv);
  try {
    options.scenes.poses = options.paths.count;
    const std::size_t wrong = graze::benchmark::run(options);
    if (wrong > 0) std::fprintf(stderr, "graze_benchmark_motion: %zu answers differ\n", wrong);
    return wrong > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_benchmark_motion: %s\n", error.what());
    return 2;
  }
}
