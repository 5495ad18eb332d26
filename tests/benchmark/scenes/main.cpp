// Scenes of the sample's solver, larger and longer than the tests run them: do bodies rest, is
// energy made, and what do contacts cost.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "samples/simulation/scenes/catalogue.h"
#include "samples/simulation/scenes/judgement.h"
#include "tests/benchmark/common/processor_name.h"

namespace graze::benchmark {
namespace {

using Json = nlohmann::ordered_json;
using samples::Outcome;
using samples::Scene;
using samples::SceneReport;

struct Options {
  std::string data = "data";
  std::string output, only;
  bool is_small = false;
};

double rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return std::stod(text);
}

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::Rests:
      return "rests";
    case Outcome::Moves:
      return "moves";
    case Outcome::Shown:
      return "shown";
  }
  return "";
}

Json row_of(const Scene& scene, const SceneReport& report, bool holds) {
  const double per_step = 1e3 / report.steps;
  Json row = {{"name", scene.name},
              {"asked", name_of(scene.outcome)},
              {"holds", holds},
              {"bodies", scene.bodies.size()},
              {"steps", report.steps},
              {"contacts", rounded(report.contacts)},
              {"drift_mm", rounded(1e3 * report.drift)},
              {"speed_mm_s", rounded(1e3 * report.speed)},
              {"energy_rise", rounded(report.energy)},
              {"deepest_mm", rounded(1e3 * report.depth)},
              {"world_ms_a_step", rounded(per_step * report.world_seconds)},
              {"solver_ms_a_step", rounded(per_step * report.solver_seconds)}};
  return row;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("graze_benchmark_scenes");
  app.add_option("--data", options.data, "Folder of the bundled data");
  app.add_option("--output", options.output, "Where to write the results");
  app.add_option("--only", options.only, "Only scenes whose names contain this");
  app.add_flag("--small", options.is_small, "The scenes of the tests");
  CLI11_PARSE(app, argc, argv);

  const auto extent = options.is_small ? samples::Extent::Small : samples::Extent::Large;
  Json rows = Json::array();
  int failed = 0, asked = 0;
  std::printf("%-24s %6s %6s %9s %12s %9s %9s %9s %9s\n", "scene", "bodies", "holds", "drift mm",
              "speed mm/s", "energy", "deep mm", "world ms", "solver ms");
  for (const Scene& scene : samples::all_scenes({.extent = extent, .data = options.data})) {
    if (scene.name.find(options.only) == std::string::npos) continue;
    const SceneReport report = samples::run_scene(scene);
    const bool holds = complaints(report, scene.outcome).empty();
    const bool is_asked = scene.outcome != Outcome::Shown;
    asked += is_asked, failed += !holds;
    std::printf("%-24s %6zu %6s %9.3g %12.3g %9.2g %9.3g %9.3g %9.3g\n", scene.name.c_str(),
                scene.bodies.size(),
                !is_asked ? "-"
                : holds   ? "yes"
                          : "NO",
                1e3 * report.drift, 1e3 * report.speed, report.energy, 1e3 * report.depth,
                1e3 * report.world_seconds / report.steps,
                1e3 * report.solver_seconds / report.steps);
    std::fflush(stdout);
    rows.push_back(row_of(scene, report, holds));
  }
  std::printf("%d of %d scenes hold\n", asked - failed, asked);
  const Json report = {{"machine", processor_name()},
                       {"extent", options.is_small ? "small" : "large"},
                       {"asked", asked},
                       {"failed", failed},
                       {"scenes", rows}};
  if (!options.output.empty()) std::ofstream(options.output) << report.dump(1) << '\n';
  return 0;
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  return graze::benchmark::run(argc, argv);
}
