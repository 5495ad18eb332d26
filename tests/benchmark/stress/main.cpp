// How graze stands where numbers are hard: scales, offsets, needles, the last doubles before a
// touch and a thread that turns. Writes what it counted as JSON and as a table in Markdown. The
// exit code is 1 if graze was wrong anywhere.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "tests/stress/flip.h"
#include "tests/stress/sweeps.h"
#include "tests/stress/turning_thread.h"

namespace graze::stress {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string data;
  std::string output;
  std::string table;
  std::size_t cases = 20000;
  std::size_t poses = 1000;
  std::size_t steps = 1000000;
  std::size_t spot_checks = 40;
};

/// The rows of the table and the JSON, as they come.
class Report {
 public:
  void add_sweep(const char* name, const std::vector<SweepRow>& rows) {
    std::fprintf(stderr, "%s\n", name);
    Json list = Json::array();
    SweepRow sum;
    for (const SweepRow& row : rows) {
      list.push_back({{"value", row.value},
                      {"cases", row.cases},
                      {"hits", row.hits},
                      {"exact", row.exact},
                      {"graze_wrong", row.wrong}});
      sum.cases += row.cases;
      sum.hits += row.hits;
      sum.wrong += row.wrong;
    }
    json_["sweeps"].push_back({{"name", name}, {"rows", list}});
    add_line(name, sum.cases, sum.hits, sum.wrong, "");
  }

  void add_flip(const BundledPair& pair, const Flip& flip, const FlipReport& report) {
    std::fprintf(stderr, "%s: the last doubles\n", pair.name.c_str());
    Json entry = {{"pair", pair.name},         {"apart", flip.apart},
                  {"hit", flip.hit},           {"poses", report.poses},
                  {"hits", report.hits},       {"changes", report.changes},
                  {"near_pairs", report.near}, {"graze_wrong", report.graze_wrong}};
    if (report.has_fcl) entry["fcl_wrong"] = report.fcl_wrong;
    json_["flips"].push_back(entry);
    add_line(pair.name + ", the last doubles before they touch", report.poses, report.hits,
             report.graze_wrong, report.has_fcl ? std::to_string(report.fcl_wrong) : "");
  }

  void add_turning(const TurningReport& report) {
    const std::size_t wrong = report.hits + report.spot_wrong + report.shifted_wrong;
    json_["turning"] = {{"steps", report.steps},
                        {"whole_nut", report.whole},
                        {"renormalised", report.renormalised},
                        {"largest_deviation", report.largest_deviation},
                        {"spot_checks", report.spot_checks},
                        {"graze_wrong", wrong}};
    add_line("a nut turning on its bolt, drifting to the door " +
                 std::to_string(report.renormalised) + " times",
             report.steps, 0, wrong, "");
  }

  const Json& json() const { return json_; }
  const std::string& table() const { return table_; }
  bool is_right() const { return wrong_ == 0; }

 private:
  void add_line(const std::string& what, std::size_t cases, std::size_t hits, std::size_t wrong,
                const std::string& fcl_wrong) {
    table_ += "| " + what + " | " + std::to_string(cases) + " | " + std::to_string(hits) + " | " +
              std::to_string(wrong) + " | " + fcl_wrong + " |\n";
    wrong_ += wrong;
  }

  Json json_;
  std::string table_ =
      "| what | queries | hits | graze wrong | FCL wrong |\n|---|---|---|---|---|\n";
  std::size_t wrong_ = 0;
};

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

bool run(const Options& options) {
  Report report;
  report.add_sweep("triangles from 1e-12 to 1e12 m", sweep_scales(1, options.cases));
  report.add_sweep("the same, a million times their size away", sweep_scales(1e6, options.cases));
  report.add_sweep("triangles of a metre up to 1e9 m away", sweep_offsets(options.cases));
  report.add_sweep("needles of aspects up to 1e17", sweep_needles(options.cases));
  for (const BundledPair& pair : bundled_pairs(options.data)) {
    const Flip flip = find_flip(pair);
    report.add_flip(pair, flip, report_flip(pair, flip, options.poses));
  }
  std::fprintf(stderr, "a nut turning on its bolt\n");
  report.add_turning(turn_nut(options.data, options.steps, options.spot_checks));
  write(options.output, report.json().dump(1) + "\n");
  write(options.table, report.table());
  return report.is_right();
}

}  // namespace
}  // namespace graze::stress

int main(int argc, char** argv) {
  graze::stress::Options options;
  CLI::App program("How graze stands where numbers are hard: counts wrong answers");
  program.add_option("--data", options.data, "folder of the bundled geometry")->required();
  program.add_option("--output", options.output, "JSON file to write")->required();
  program.add_option("--table", options.table, "table in Markdown to write")->required();
  program.add_option("--cases", options.cases, "pairs of triangles at each value (default 20000)")
      ->check(CLI::Range(1, 10000000));
  program
      .add_option("--poses", options.poses, "neighbouring doubles around each flip (default 1000)")
      ->check(CLI::Range(2, 10000000));
  program.add_option("--steps", options.steps, "steps of the turning nut (default 1000000)")
      ->check(CLI::Range(1, 100000000));
  program.add_option("--spot-checks", options.spot_checks, "of these judged in full (default 40)")
      ->check(CLI::Range(1, 100000));
  CLI11_PARSE(program, argc, argv);
  try {
    return graze::stress::run(options) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_stress_report: %s\n", error.what());
    return 2;
  }
}
