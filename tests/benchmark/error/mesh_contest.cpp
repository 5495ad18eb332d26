#include "tests/benchmark/error/mesh_contest.h"

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/pose_text.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include "tests/benchmark/common/mesh_truth.h"
#include "tests/benchmark/error/bundled_meshes.h"

namespace graze::benchmark {
namespace {

namespace fs = std::filesystem;

template <typename Query>
double median_nanoseconds(int repetitions, const Query& query) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const ThreadClock clock;
    query();
    times.push_back(clock.nanoseconds());
  }
  return median(times);
}

std::size_t missing(const std::vector<IndexPair>& from, const std::vector<IndexPair>& sorted) {
  std::vector<IndexPair> rest;
  std::set_difference(sorted.begin(), sorted.end(), from.begin(), from.end(),
                      std::back_inserter(rest));
  return rest.size();
}

/// One contestant, one pose; times are added up.
void ask(MeshContestant& contestant, const Pose& pose, const MeshTruth& truth, int repetitions,
         Score& any_score, Score& pairs_score) {
  bool is_hit = false;
  any_score.nanoseconds += median_nanoseconds(repetitions, [&] { is_hit = contestant.any(pose); });
  count(any_score, to_answer(is_hit), !truth.pairs.empty());
  std::vector<IndexPair> pairs;
  pairs_score.nanoseconds += median_nanoseconds(repetitions, [&] { contestant.find(pose, pairs); });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  pairs_score.false_positives += missing(truth.pairs, pairs);
  pairs_score.false_negatives += missing(pairs, truth.pairs);
}

class MeshContest {
 public:
  MeshContest(const MeshContestants& contestants, const MeshSettings& settings)
      : contestants_(contestants), settings_(settings) {
    for (const auto& contestant : contestants) {
      any_.labels.push_back(contestant->label());
      pairs_.labels.push_back(contestant->label());
    }
    any_.scores.resize(contestants.size());
    pairs_.scores.resize(contestants.size());
  }

  void run(const MeshFiles& files) {
    const fs::path data = settings_.data;
    const Mesh mesh_a = load_mesh(data / "meshes" / files.a);
    const Mesh mesh_b = load_mesh(data / "meshes" / files.b);
    for (const auto& contestant : contestants_)
      contestant->prepare(mesh_a, mesh_b);
    for (const fs::path& file : pose_files(data / "poses", files.name)) {
      std::fprintf(stderr, "\rmeshes: %-40s", file.stem().c_str());
      run(file.stem(), mesh_a, mesh_b, spread(load_poses(file), settings_.poses));
    }
  }

  std::vector<QuestionResult> results() && {
    std::fputc('\n', stderr);
    return {std::move(any_), std::move(pairs_)};
  }

 private:
  void run(const std::string& name, const Mesh& mesh_a, const Mesh& mesh_b,
           const std::vector<Pose>& poses) {
    std::vector<Score> any_scores(contestants_.size());
    std::vector<Score> pairs_scores(contestants_.size());
    CategoryFacts any{name, false, false, poses.size(), 0, poses.size()};
    CategoryFacts pairs{name, false, false, 0, 0, 0};
    for (const Pose& pose : poses) {
      const MeshTruth truth = truth_of(mesh_a, mesh_b, pose);
      any.hits += !truth.pairs.empty();
      pairs.elements += truth.candidates;
      pairs.hits += truth.pairs.size();
      for (std::size_t i = 0; i < contestants_.size(); ++i)
        ask(*contestants_[i], pose, truth, settings_.repetitions, any_scores[i], pairs_scores[i]);
    }
    pairs.refereed = pairs.elements;
    for (std::size_t i = 0; i < contestants_.size(); ++i) {
      any_scores[i].nanoseconds /= static_cast<double>(poses.size());
      pairs_scores[i].nanoseconds /= static_cast<double>(poses.size());
      any_.scores[i].push_back(any_scores[i]);
      pairs_.scores[i].push_back(pairs_scores[i]);
    }
    any_.categories.push_back(any);
    pairs_.categories.push_back(pairs);
  }

  const MeshContestants& contestants_;
  const MeshSettings& settings_;
  QuestionResult any_{"meshes, any", {}, {}, {}};
  QuestionResult pairs_{"meshes, all pairs", {}, {}, {}};
};

}  // namespace

std::vector<QuestionResult> contest_of_meshes(const MeshContestants& contestants,
                                              const MeshSettings& settings) {
  MeshContest contest(contestants, settings);
  for (const MeshFiles& files : mesh_files())
    contest.run(files);
  return std::move(contest).results();
}

}  // namespace graze::benchmark
