// Two meshes, a pose, a question: the library and others answer the same ones, in one process, and
// what they take stands beside how often they differ.

#include <graze/bvh/error.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/pairs/contest.h"
#include "tests/benchmark/pairs/peers/peers.h"
#include "tests/benchmark/pairs/report.h"
#include "tests/benchmark/pairs/scene.h"

namespace graze::benchmark {
namespace {

struct Options {
  std::string output;
  SceneSettings scenes;
  ContestSettings contest;
  std::size_t parallel_poses = 20;
  std::size_t scaling_poses = 30;
  std::size_t most_for_peers = 300000;
};

PairContestants all_contestants() {
  PairContestants contestants;
  add_graze(contestants);
  for (const Peer& peer : peers())
    peer.add(contestants);
  for (const std::string& name : absent_peers())
    std::fprintf(stderr, "%s was not found when this was built: left out\n", name.c_str());
  return contestants;
}

Json to_json(const PairContestants& contestants) {
  Json rows = Json::array();
  for (const auto& contestant : contestants) {
    Json left_out = Json::object();
    for (const Question question : kQuestions) {
      if (const std::string why = contestant->refusal(question); !why.empty())
        left_out[name_of(question)] = why;
    }
    rows.push_back({{"contestant", contestant->name()}, {"left_out", left_out}});
  }
  return rows;
}

void run(const Options& options) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    options.contest.build.threads);
  PairContestants contestants = all_contestants();
  Json document{{"processor", processor_name()},
                {"threads", options.contest.build.threads},
                {"repetitions", options.contest.repetitions},
                {"absent", absent_peers()},
                {"contestants", to_json(contestants)},
                {"scenes", Json::array()}};
  const auto measure = [&](const std::vector<SceneMaker>& scenes, const ContestSettings& contest) {
    for (const SceneMaker& make_scene : scenes)
      document["scenes"].push_back(to_json(contest_over(make_scene(), contestants, contest)));
  };
  measure(mesh_scenes(options.scenes), options.contest);
  SceneSettings parallel = options.scenes;
  parallel.poses = options.parallel_poses;
  measure(parallel_scenes(parallel), options.contest);
  SceneSettings scaled = options.scenes;
  scaled.poses = options.scaling_poses;
  ContestSettings contest = options.contest;
  contest.checked = std::min<std::size_t>(contest.checked, 1);
  contest.build.repetitions = 1;
  contest.most_for_peers = options.most_for_peers;
  measure(scaling_scenes(scaled), contest);
  std::fputc('\n', stderr);
  write(document, options.output);
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  graze::benchmark::Options options;
  CLI::App program("Mesh pairs beside other libraries: writes measurements as JSON");
  const auto count = CLI::Range(std::size_t{1}, std::size_t{100000000});
  program.add_option("--data", options.scenes.data, "folder of the bundled geometry")->required();
  program.add_option("--output", options.output, "JSON file to write")->required();
  program.add_option(
      "--pair", options.scenes.pairs,
      "two more meshes, A B, with poses in A-B.REGIME.txt beside A if there are any; "
      "may be repeated");
  program.add_option("--poses", options.scenes.poses, "poses in each regime (default 60)")
      ->check(count);
  program
      .add_option("--parallel-poses", options.parallel_poses,
                  "likewise for the nearly parallel surfaces (default 20)")
      ->check(count);
  program
      .add_option("--scaling-poses", options.scaling_poses,
                  "likewise for the refined mesh (default 30)")
      ->check(count);
  program
      .add_option("--scaling-triangles", options.scenes.most_triangles,
                  "of the refined mesh at most (default 4000000)")
      ->check(count);
  program
      .add_option("--peer-triangles", options.most_for_peers,
                  "of the refined mesh at most where others take part (default 300000)")
      ->check(count);
  program
      .add_option("--checked", options.contest.checked,
                  "poses in each regime that brute force checks (default 6)")
      ->check(count);
  program.add_option("--repetitions", options.contest.repetitions, "of each query (default 5)")
      ->check(CLI::Range(1, 1000));
  program.add_option("--builds", options.contest.build.repetitions, "of each tree (default 3)")
      ->check(CLI::Range(1, 1000));
  program.add_option("--threads", options.contest.build.threads, "that builds may use (default 1)")
      ->check(CLI::Range(1, 1024));
  CLI11_PARSE(program, argc, argv);
  try {
    graze::benchmark::run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_benchmark_pairs: %s\n", error.what());
    return 2;
  }
}
