// Boxes only: all overlapping pairs of moving boxes in every frame, beside other libraries; and
// what a step costs with few movers, or with boxes that come and go.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/benchmark/broad_phase/graze_contestant.h"
#include "tests/benchmark/broad_phase/measure.h"
#include "tests/benchmark/broad_phase/peers/peers.h"
#include "tests/benchmark/common/processor_name.h"

namespace graze::benchmark {
namespace {

constexpr double kStartPatience = 25000;  // milliseconds

struct Options {
  std::vector<std::string> scenes = {"S1", "S2", "S3", "S4", "S5"};
  std::vector<std::uint32_t> sizes = {1000, 10000, 100000, 1000000};
  int frames = 40;
  double patience = 2000;  // milliseconds that a frame may take
  double budget = 4000;    // milliseconds that the frames of a course may take together
  std::vector<std::string> only;
  std::string json;
};

nlohmann::json to_json(const Score& score) {
  nlohmann::json row = {{"scene", score.scene},           {"boxes", score.boxes},
                        {"contestant", score.contestant}, {"frames", score.frames},
                        {"start_ms", score.start},        {"median_ms", score.median},
                        {"mean_ms", score.mean},          {"slowest_ms", score.slowest},
                        {"pairs", score.pairs},           {"wrong_frames", score.wrong_frames}};
  if (score.bytes_per_box != 0) row["bytes_per_box"] = score.bytes_per_box;
  return row;
}

void print(const Score& score) {
  std::cout << score.scene << std::setw(9) << score.boxes << std::fixed << std::setprecision(3)
            << std::setw(12) << score.median << " ms, mean " << std::setw(9) << score.mean
            << ", slowest " << std::setw(9) << score.slowest << "  " << score.contestant;
  if (score.wrong_frames != 0)
    std::cout << "  WRONG in " << score.wrong_frames << " of " << score.frames << " frames";
  std::cout << std::endl;
}

nlohmann::json contest(const Options& options, std::vector<Entry>& entries) {
  nlohmann::json rows = nlohmann::json::array();
  std::map<std::string, bool> rests;
  for (const std::string& scene : options.scenes) {
    for (const std::uint32_t size : options.sizes) {
      Truth truth;
      double own = 0, best = 0;
      std::string best_name;
      for (const Entry& entry : entries) {
        bool& is_resting = rests[scene + entry.name];
        if (is_resting) continue;
        const Score score =
            measure(entry, {scene, size, options.frames, options.patience, options.budget}, truth);
        // The next size is ten times this one. Some need the square of the size to start.
        is_resting = 10 * score.median > options.patience || 100 * score.start > kStartPatience;
        print(score);
        rows.push_back(to_json(score));
        if (entry.name == "graze") own = score.median;
        const bool is_peer = entry.name.rfind("graze", 0) != 0;
        if (is_peer && score.wrong_frames == 0 && (best == 0 || score.median < best)) {
          best = score.median, best_name = entry.name;
        }
      }
      if (best != 0) {
        std::cout << scene << std::setw(9) << size << std::setprecision(2) << "  " << best / own
                  << " times as fast as the best peer, " << best_name << "\n\n";
      }
    }
  }
  return rows;
}

nlohmann::json movers(const Options& options) {
  nlohmann::json rows = nlohmann::json::array();
  for (const std::uint32_t size : options.sizes) {
    for (const std::uint32_t count : {0u, 10u, 1000u}) {
      if (count >= size) continue;
      const double microseconds = measure_movers(size, count, options.frames);
      std::cout << size << " boxes, " << count << " movers: " << std::setprecision(2)
                << microseconds << " us a step\n";
      rows.push_back({{"boxes", size}, {"movers", count}, {"median_us", microseconds}});
    }
  }
  return rows;
}

/// Boxes that come and go: one in so many in each frame.
nlohmann::json churn(Options options, std::vector<Entry>& entries) {
  nlohmann::json rows = nlohmann::json::array();
  std::vector<Entry> own = {entries.front()};
  options.budget /= 4;
  for (const std::uint32_t one_in : {1000u, 100u, 50u, 10u}) {
    options.scenes = {"R" + std::to_string(one_in)};
    for (nlohmann::json& row : contest(options, one_in == 100 || one_in == 10 ? entries : own)) {
      row.erase("scene");
      row["replaced"] = row["boxes"].get<std::uint32_t>() / one_in;
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("graze_benchmark_broad_phase");
  app.add_option("--scenes", options.scenes, "S1 to S5");
  app.add_option("--sizes", options.sizes, "Numbers of boxes");
  app.add_option("--frames", options.frames, "Frames of each scene")->check(CLI::PositiveNumber);
  app.add_option("--patience", options.patience,
                 "Milliseconds that a frame may take; who would need more rests");
  app.add_option("--budget", options.budget,
                 "Milliseconds that all frames of a scene may take; a few frames are always taken");
  app.add_option("--only", options.only,
                 "Contestants whose names begin so; graze sets the truth and always runs");
  app.add_option("--json", options.json, "Where to write the results");
  CLI11_PARSE(app, argc, argv);

  std::vector<Entry> entries = {{"graze", [] { return make_graze(1); }},
                                {"graze, 2 threads", [] { return make_graze(2); }, 2}};
  add_peers(entries);
  if (!options.only.empty()) {
    std::erase_if(entries, [&](const Entry& entry) {
      return entry.name != "graze" &&
             std::none_of(options.only.begin(), options.only.end(), [&](const std::string& start) {
               return entry.name.rfind(start, 0) == 0;
             });
    });
  }
  for (const std::string& name : absent_peers())
    std::cout << name << " was not found and is left out\n";
  const nlohmann::json report = {{"processor", processor_name()},
                                 {"scenes", contest(options, entries)},
                                 {"movers", movers(options)},
                                 {"churn", churn(options, entries)}};
  if (!options.json.empty()) std::ofstream(options.json) << report.dump(1) << '\n';
  return 0;
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  return graze::benchmark::run(argc, argv);
}
