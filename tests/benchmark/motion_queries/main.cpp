// First contacts on straight paths, set by set: nanoseconds a query, and wrong and late answers by
// rational arithmetic that shares nothing with the library.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/motion_queries/mesh_casts.h"
#include "tests/benchmark/motion_queries/queries.h"
#include "tests/narrowphase/motion/rational_contact.h"

namespace graze::benchmark {
namespace {

struct Options {
  int queries = 1000;
  int refereed = 100;
  int casts = 400;
  int repetitions = 5;
  std::string folder;
  std::string output = "motion_queries.json";
};

struct Score {
  double mean = 0;    ///< nanoseconds a query, of the medians of each
  double middle = 0;  ///< the median of those
  double worst = 0;
  int hits = 0;
  int wrong = 0;  ///< of the refereed, and of those that a file knows
  int late = 0;
  int refereed = 0;
};

std::optional<FirstContact> truth_of(const MotionQuery& query) {
  if (query.is_edges)
    return oracle::rational_first_contact(query.edge_a, query.edge_b, StartContact::Counts);
  return oracle::rational_first_contact(query.point, query.triangle, StartContact::Counts);
}

/// Each query's median over rounds of the whole set; a clock around each would cost more than many
/// of them take, so that those below a microsecond are timed many at a time.
Score time_set(const MotionSet& set, int repetitions) {
  constexpr std::size_t kBlock = 8;
  constexpr int kRounds = 4;
  const std::size_t blocks = (set.queries.size() + kBlock - 1) / kBlock;
  std::vector<std::vector<double>> times(blocks);
  Score score;
  int hits = 0;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::size_t first = block * kBlock;
      const std::size_t last = std::min(set.queries.size(), first + kBlock);
      hits = 0;
      const ThreadClock clock;
      for (int round = 0; round < kRounds; ++round) {
        for (std::size_t i = first; i < last; ++i)
          hits += set.queries[i].first_contact().has_value();
      }
      times[block].push_back(clock.nanoseconds() / static_cast<double>(kRounds * (last - first)));
      if (repetition == 0) score.hits += hits / kRounds;
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& of_block : times)
    medians.push_back(median(of_block));
  for (double time : medians)
    score.mean += time / static_cast<double>(medians.size());
  score.worst = *std::max_element(medians.begin(), medians.end());
  score.middle = median(medians);
  return score;
}

void referee(const MotionSet& set, int refereed, Score& score) {
  const std::size_t stride =
      std::max<std::size_t>(1, set.queries.size() / static_cast<std::size_t>(refereed));
  for (std::size_t i = 0; i < set.queries.size(); ++i) {
    const MotionQuery& query = set.queries[i];
    const auto answer = query.first_contact();
    if (query.is_hit) score.wrong += *query.is_hit != answer.has_value();
    if (i % stride != 0) continue;
    const auto truth = truth_of(query);
    ++score.refereed;
    score.wrong += truth.has_value() != answer.has_value();
    score.late += truth && answer && answer->time > truth->time;
    score.wrong += truth && answer && *answer != *truth && answer->time <= truth->time;
  }
}

void run(const Options& options) {
  std::vector<MotionSet> sets =
      options.folder.empty() ? made_sets(options.queries) : sets_of_folder(options.folder);
  nlohmann::ordered_json document{{"processor", processor_name()},
                                  {"rows", nlohmann::ordered_json::array()}};
  std::printf("%-30s %8s %8s %8s %10s %6s %9s %6s %5s\n", "set", "queries", "hits", "mean ns",
              "median ns", "worst", "refereed", "wrong", "late");
  for (const MotionSet& set : sets) {
    Score score = time_set(set, options.repetitions);
    referee(set, options.refereed, score);
    std::printf("%-30s %8zu %8d %8.0f %10.0f %6.0f %9d %6d %5d\n", set.name.c_str(),
                set.queries.size(), score.hits, score.mean, score.middle, score.worst,
                score.refereed, score.wrong, score.late);
    std::fflush(stdout);
    document["rows"].push_back({{"set", set.name},
                                {"queries", set.queries.size()},
                                {"hits", score.hits},
                                {"mean_ns", score.mean},
                                {"median_ns", score.middle},
                                {"worst_ns", score.worst},
                                {"refereed", score.refereed},
                                {"wrong", score.wrong},
                                {"late", score.late}});
  }
  document["casts"] = measure_mesh_casts(options.casts, options.repetitions);
  std::ofstream(options.output) << document.dump(2) << "\n";
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  graze::benchmark::Options options;
  CLI::App app{"Nanoseconds a query: first contacts on straight paths"};
  app.add_option("--queries", options.queries, "queries a set")->check(CLI::PositiveNumber);
  app.add_option("--refereed", options.refereed, "queries a set that rational arithmetic answers")
      ->check(CLI::PositiveNumber);
  app.add_option("--casts", options.casts, "casts a pair of meshes")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", options.repetitions, "rounds, of which medians are taken")
      ->check(CLI::PositiveNumber);
  app.add_option("--folder", options.folder, "sample queries in files, in place of those made here")
      ->check(CLI::ExistingDirectory);
  app.add_option("--output", options.output, "where to write the figures as JSON")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  graze::benchmark::run(options);
}
