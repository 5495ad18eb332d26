#include "tests/benchmark/pairs/contest.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "tests/benchmark/common/mesh_truth.h"
#include "tests/benchmark/pairs/timing.h"

namespace graze::benchmark {
namespace {

/// Of the size: the middle one of the gaps of "near".
constexpr double kClearance = 0.01;

/// Distances are rounded by everyone; this share of the size is no difference.
constexpr double kSameDistance = 1e-9;

/// What a contestant says in one pose.
struct Answers {
  bool any = false;
  std::vector<TrianglePair> pairs;
  double distance = 0;
  bool within = false;
};

double ask(PairContestant& contestant, Question question, const Pose& pose, double clearance,
           int repetitions, Answers& answers) {
  return microseconds_of(repetitions, [&] {
    switch (question) {
      case Question::Any:
        answers.any = contestant.any(pose);
        break;
      case Question::Pairs:
        contestant.find(pose, answers.pairs);
        break;
      case Question::Distance:
        answers.distance = contestant.distance(pose);
        break;
      case Question::Within:
        answers.within = contestant.within(pose, clearance);
        break;
    }
  });
}

bool is_same(Question question, const Answers& answers, const Answers& reference, double size) {
  switch (question) {
    case Question::Any:
      return answers.any == reference.any;
    case Question::Pairs:
      return answers.pairs == reference.pairs;
    case Question::Distance:
      return std::abs(answers.distance - reference.distance) <= kSameDistance * size;
    case Question::Within:
      return answers.within == reference.within;
  }
  return false;
}

void sort_pairs(std::vector<TrianglePair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// The default's own answers. Throws Error if they contradict each other, or brute force.
Answers reference_in(const Scene& scene, PairContestant& contestant, const Pose& pose,
                     double clearance, bool is_checked) {
  Answers answers;
  answers.any = contestant.any(pose);
  contestant.find(pose, answers.pairs);
  answers.distance = contestant.distance(pose);
  answers.within = contestant.within(pose, clearance);
  const bool is_sound = answers.any == !answers.pairs.empty() &&
                        answers.any == (answers.distance == 0) &&
                        answers.within == (answers.distance <= clearance);
  if (!is_sound) throw Error(scene.name + ": the library's answers contradict each other");
  if (is_checked && truth_of(scene.mesh_a, scene.mesh_b, pose).pairs != answers.pairs)
    throw Error(scene.name + ": the library's pairs are not those of brute force");
  return answers;
}

class SceneContest {
 public:
  SceneContest(const Scene& scene, PairContestants& contestants, const ContestSettings& settings)
      : scene_(scene), settings_(settings), clearance_(kClearance * scene.size()) {
    result_.kind = scene.kind;
    result_.name = scene.name;
    result_.triangles_a = scene.mesh_a.triangles().size();
    result_.triangles_b = scene.mesh_b.triangles().size();
    result_.clearance = clearance_;
    for (const Mesh& mesh : {scene.mesh_a, scene.mesh_b})
      result_.mesh_bytes += mesh.vertices().size_bytes() + mesh.triangles().size_bytes();
    for (const auto& contestant : contestants)
      build(*contestant);
  }

  SceneResult run() && {
    for (const RegimePoses& regime : scene_.regimes) {
      std::fprintf(stderr, "\r%-60s", (scene_.name + ": " + regime.name).c_str());
      result_.regimes.push_back(run(regime));
    }
    for (PairContestant* contestant : present_)
      contestant->release();
    return std::move(result_);
  }

 private:
  void build(PairContestant& contestant) {
    std::fprintf(stderr, "\r%-60s", (scene_.name + ": build of " + contestant.name()).c_str());
    BuildRow row{contestant.name(), "", {}};
    const std::size_t largest = std::max(result_.triangles_a, result_.triangles_b);
    const bool is_peer = !contestant.name().starts_with("graze");
    if (is_peer && settings_.most_for_peers > 0 && largest > settings_.most_for_peers)
      row.refusal = "left out of the largest meshes";
    try {
      if (row.refusal.empty()) row.measure = measure_build(contestant, scene_, settings_.build);
    } catch (const std::exception& error) {
      row.refusal = error.what();
      contestant.release();
    }
    if (row.refusal.empty()) present_.push_back(&contestant);
    result_.builds.push_back(std::move(row));
  }

  RegimeResult run(const RegimePoses& regime) {
    RegimeResult result{regime.name, regime.source, regime.poses.size(), 0, 0, 0, {}};
    for (const PairContestant* contestant : present_) {
      for (const Question question : kQuestions) {
        if (contestant->refusal(question).empty())
          result.scores.push_back({contestant->name(), question, {}, 0, std::nullopt});
      }
    }
    const std::size_t poses = regime.poses.size();
    const std::size_t checked = std::min(settings_.checked, poses);
    for (std::size_t i = 0; i < poses; ++i) {
      // Every so often, so that `checked` of all are.
      const bool is_checked = (i + 1) * checked / poses > i * checked / poses;
      const Answers reference =
          reference_in(scene_, *present_.front(), regime.poses[i], clearance_, is_checked);
      result.checked += is_checked;
      result.hits += reference.any;
      result.pairs += reference.pairs.size();
      for (std::size_t k = 0; k < present_.size(); ++k)
        answer(*present_[(i + k) % present_.size()], regime.poses[i], reference, result);
    }
    return result;
  }

  void answer(PairContestant& contestant, const Pose& pose, const Answers& reference,
              RegimeResult& result) {
    for (Score& score : result.scores) {
      if (score.contestant != contestant.name()) continue;
      Answers answers;
      score.microseconds.push_back(
          ask(contestant, score.question, pose, clearance_, settings_.repetitions, answers));
      sort_pairs(answers.pairs);
      score.wrong += !is_same(score.question, answers, reference, scene_.size());
      if (const auto work = contestant.work(score.question, pose, clearance_)) {
        if (!score.work) score.work.emplace();
        *score.work += *work;
      }
    }
  }

  const Scene& scene_;
  const ContestSettings& settings_;
  double clearance_;
  std::vector<PairContestant*> present_;
  SceneResult result_;
};

}  // namespace

SceneResult contest_over(const Scene& scene, PairContestants& contestants,
                         const ContestSettings& settings) {
  return SceneContest(scene, contestants, settings).run();
}

}  // namespace graze::benchmark
