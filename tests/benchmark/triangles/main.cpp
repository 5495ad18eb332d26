// graze_benchmark_triangles: what an answer costs, and how many are wrong.

#include <tests/benchmark/triangles/box_contestants.h>
#include <tests/benchmark/triangles/box_sets.h>
#include <tests/benchmark/triangles/pair_contestants.h>
#include <tests/benchmark/triangles/pair_sets.h>
#include <tests/benchmark/triangles/report.h>
#include <CLI/CLI.hpp>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace graze::benchmark {
namespace {

struct Options {
  std::size_t elements = 20000;
  int repetitions = 9;
  std::string filter;
  std::string json;
};

template <typename MakeSet, typename MakeContestants>
std::vector<Score> run(const std::vector<std::string>& names, MakeSet make_set,
                       MakeContestants make_contestants, const Options& options) {
  std::vector<Score> scores;
  for (const std::string& name : names) {
    if (name.find(options.filter) == std::string::npos) continue;
    const auto set = make_set(name, options.elements);
    const auto rows =
        contest(set, make_contestants(name), truth_of(set.elements), options.repetitions);
    scores.insert(scores.end(), rows.begin(), rows.end());
  }
  return scores;
}

int run(const Options& options) {
  const auto pairs = run(pair_set_names(), pair_set, pair_contestants, options);
  write_table(std::cout, "Triangle against triangle", pairs);
  const auto boxes = run(box_set_names(), box_set, box_contestants, options);
  write_table(std::cout, "Triangle against box", boxes);
  if (!options.json.empty()) {
    std::ofstream file(options.json);
    write_json(file, pairs, boxes);
    if (!file.flush()) {
      std::cerr << "cannot write " << options.json << '\n';
      return 1;
    }
  }
  return 0;
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  graze::benchmark::Options options;
  CLI::App app("The cost of exact tests of triangles, beside plain-double ones");
  app.add_option("--elements", options.elements,
                 "of each set; fewer than 20000 are learnt by a CPU")
      ->check(CLI::PositiveNumber);
  app.add_option("--repetitions", options.repetitions, "of which the median counts")
      ->check(CLI::PositiveNumber);
  app.add_option("--filter", options.filter, "only sets whose names contain this");
  app.add_option("--json", options.json, "also write the scores into this file");
  CLI11_PARSE(app, argc, argv);
  return graze::benchmark::run(options);
}
