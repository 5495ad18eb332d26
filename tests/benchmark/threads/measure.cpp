#include "tests/benchmark/threads/measure.h"

#include <graze/engine/mesh/pose_batch.h>

#include "tests/benchmark/common/stopwatch.h"

namespace graze::benchmark {
namespace {

/// All answers of one round, and how long they took.
struct Round {
  std::vector<bool> is_hit;
  std::vector<std::vector<TrianglePair>> pairs;
  double microseconds = 0;

  bool has_same_answers(const Round& other) const {
    return is_hit == other.is_hit && pairs == other.pairs;
  }
};

Round run_round(const Scene& scene, const std::vector<Pose>& poses, Sharing sharing, int threads) {
  const PlacedMeshView a{scene.mesh_a};
  Round round;
  std::vector<TrianglePairs> found;
  const Stopwatch watch;
  switch (sharing) {
    case Sharing::AnyOfPoses:
      round.is_hit = intersects(a, {scene.mesh_b, poses}, {}, {.threads = threads});
      break;
    case Sharing::PairsOfPoses:
      found = find_triangle_pairs(a, {scene.mesh_b, poses}, {}, {.threads = threads});
      break;
    case Sharing::OneQuery:
      for (const Pose& pose : poses)
        found.push_back(find_triangle_pairs(a, {scene.mesh_b, pose}, {.threads = threads}));
      break;
  }
  round.microseconds = watch.microseconds();
  for (TrianglePairs& of_one : found)
    round.pairs.push_back(std::move(of_one.pairs));
  return round;
}

}  // namespace

const char* name_of(Sharing sharing) {
  switch (sharing) {
    case Sharing::AnyOfPoses:
      return "any, of poses";
    case Sharing::PairsOfPoses:
      return "pairs, of poses";
    case Sharing::OneQuery:
      return "pairs, one query";
  }
  return "";
}

ThreadTimes measure_threads(const Scene& scene, const RegimePoses& regime, Sharing sharing,
                            const std::vector<int>& threads, int rounds) {
  const Round expected = run_round(scene, regime.poses, sharing, 1);  // and builds what is needed
  ThreadTimes times;
  for (const auto& pairs : expected.pairs)
    times.pairs += pairs.size();
  std::vector<std::vector<double>> samples(threads.size());
  for (int i = 0; i < rounds; ++i) {
    for (std::size_t k = 0; k < threads.size(); ++k) {
      const Round round = run_round(scene, regime.poses, sharing, threads[k]);
      samples[k].push_back(round.microseconds / static_cast<double>(regime.poses.size()));
      times.wrong += !round.has_same_answers(expected);
    }
  }
  for (const std::vector<double>& of_one : samples)
    times.microseconds.push_back(median(of_one));
  return times;
}

}  // namespace graze::benchmark
