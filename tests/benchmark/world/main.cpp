// Worlds with all contacts in every frame, beside other libraries in the same poses; and what a
// step costs with few movers.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/world/movers.h"
#include "tests/benchmark/world/peers/peers.h"
#include "tests/benchmark/world/settling.h"

namespace graze::benchmark {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string data = "data";
  std::string output, keep;
  std::vector<std::string> scenes = {"pile", "pour", "crowd"};
  std::size_t pile = 10000, pour = 1000;
  std::vector<std::size_t> crowd = {1000, 10000, 100000, 1000000};
  std::size_t frames = 20;
  bool alone = false;
};

struct Running {
  std::string name;
  std::unique_ptr<Contestant> contestant;
  std::vector<double> milliseconds = {};
  Counts counts = {};
  Lasting lasting = {};
};

double rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return std::stod(text);
}

/// Contestants take turns frame by frame.
Json contest(const Scene& scene, const std::vector<Frame>& path,
             const std::vector<Entry>& entries) {
  std::vector<Running> all;
  for (const Entry& entry : entries) {
    all.push_back({.name = entry.name, .contestant = entry.make()});
    all.back().contestant->start(scene, path.front());
    all.back().contestant->lasting();
  }
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (Running& running : all) {
      const ThreadClock clock;
      running.counts = running.contestant->step(path[i]);
      running.milliseconds.push_back(clock.nanoseconds() * 1e-6);
      running.lasting = running.contestant->lasting();
    }
  }
  Json rows = Json::array();
  double best = std::numeric_limits<double>::infinity();
  for (const Running& running : all) {
    const double time = median(running.milliseconds);
    if (&running != all.data()) best = std::min(best, time);
    std::printf("%-6s %-22s %10.3f ms %8zu pairs %8zu contacts", scene.name.c_str(),
                running.name.c_str(), time, running.counts.pairs, running.counts.contacts);
    const Lasting& lasting = running.lasting;
    if (lasting.by_features >= 0) {
      std::printf(", %.0f %% keep their features; %.0f %% go on, which takes %.3f ms to know",
                  100 * lasting.by_features, 100 * lasting.by_tracker, lasting.tracker_ms);
    }
    std::printf("\n");
    Json row = {{"contestant", running.name},
                {"median_ms", rounded(time)},
                {"pairs", running.counts.pairs},
                {"contacts", running.counts.contacts}};
    if (lasting.by_features >= 0) {
      row["kept_features"] = rounded(lasting.by_features);
      row["kept_ids"] = rounded(lasting.by_tracker);
      row["tracker_ms"] = rounded(lasting.tracker_ms);
    }
    rows.push_back(row);
  }
  if (all.size() > 1)
    std::printf("%-6s the best peer takes %.1f times as long\n", scene.name.c_str(),
                best / median(all.front().milliseconds));
  return rows;
}

Json movers(const Scene& scene, const std::vector<Frame>& path) {
  Json rows = Json::array();
  for (const MoverTime& time : measure_movers(scene, path)) {
    std::printf("%-6s %6zu movers %12.1f us a step\n", scene.name.c_str(), time.movers,
                time.microseconds);
    rows.push_back({{"movers", time.movers}, {"median_us", rounded(time.microseconds)}});
  }
  return rows;
}

Json crowds(const Options& options) {
  Json rows = Json::array();
  for (const std::size_t bodies : options.crowd) {
    for (const CrowdTime& time : measure_crowd(bodies, {0, 10, 1000}, 10 * options.frames)) {
      std::printf("crowd  %8zu bodies %6zu movers %10.2f us a step, %.0f pairs tested\n", bodies,
                  time.movers, time.microseconds, time.tested);
      rows.push_back({{"bodies", bodies},
                      {"movers", time.movers},
                      {"median_us", rounded(time.microseconds)},
                      {"tested", rounded(time.tested)}});
    }
  }
  return rows;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("graze_benchmark_world");
  app.add_option("--data", options.data, "Folder of the bundled data");
  app.add_option("--output", options.output, "Where to write the results");
  app.add_option("--keep", options.keep, "Folder in which paths are kept from run to run");
  app.add_option("--scenes", options.scenes, "pile, pour, crowd");
  app.add_option("--pile", options.pile, "Boxes and spheres");
  app.add_option("--pour", options.pour, "Bolts and nuts");
  app.add_option("--crowd", options.crowd, "Boxes and balls at rest, of which few move");
  app.add_option("--frames", options.frames, "Frames of each scene")->check(CLI::Range(2, 10000));
  app.add_flag("--alone", options.alone, "No peers");
  CLI11_PARSE(app, argc, argv);

  std::vector<Entry> entries = {{"graze", make_graze}};
  if (!options.alone) {
    for (const Peer& peer : peers())
      peer.add(entries);
    for (const std::string& name : absent_peers())
      std::printf("%s was not found and is left out\n", name.c_str());
  }
  Json report = {{"machine", processor_name()}, {"frames", options.frames}};
  for (const std::string& name : options.scenes) {
    if (name == "crowd") {
      report[name] = crowds(options);
      continue;
    }
    const Scene scene = name == "pile" ? make_pile(options.pile, options.data)
                                       : make_pour(options.pour, options.data);
    std::string file;
    if (!options.keep.empty()) {
      std::filesystem::create_directories(options.keep);
      file = options.keep + "/" + name + "-" + std::to_string(scene.bodies.size()) + ".poses";
    }
    const std::vector<Frame> path = settle_once(scene, options.frames, file);
    report[name] = {{"bodies", scene.bodies.size()},
                    {"ground_triangles", scene.ground.triangles().size()},
                    {"contestants", contest(scene, path, entries)},
                    {"movers", movers(scene, path)}};
  }
  if (!options.output.empty()) std::ofstream(options.output) << report.dump(1) << '\n';
  return 0;
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  return graze::benchmark::run(argc, argv);
}
