#include "tests/benchmark/volumes/measure_queries.h"

#include <graze/bvh/error.h>
#include <graze/engine/mesh/pair.h>

#include <string>

#include "tests/benchmark/common/stopwatch.h"

namespace graze::benchmark {
namespace {

template <typename Query>
double median_microseconds(int repetitions, const Query& query) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const Stopwatch watch;
    query();
    times.push_back(watch.microseconds());
  }
  return median(times);
}

/// The times of one volume, pose by pose.
struct Times {
  std::vector<double> any;
  std::vector<double> pairs;
};

void measure_pose(QueryMeasure& measure, Times& times, const PlacedMesh& a, const PlacedMesh& b,
                  int repetitions) {
  const QuerySettings settings{.volume = measure.volume};
  const PairSettings pair_settings{.volume = measure.volume};
  bool is_hit = intersects(a, b, settings, &measure.any);  // also warms the caches
  times.any.push_back(
      median_microseconds(repetitions, [&] { is_hit &= intersects(a, b, settings); }));
  TrianglePairs found = find_triangle_pairs(a, b, pair_settings, &measure.pairs);
  measure.hits += found.size();
  if (is_hit == found.empty()) throw Error("a boolean query and the pairs disagree");
  times.pairs.push_back(
      median_microseconds(repetitions, [&] { found = find_triangle_pairs(a, b, pair_settings); }));
}

}  // namespace

double QueryMeasure::false_share() const {
  if (pairs.triangle_tests == 0) return 0;
  return 1 - static_cast<double>(hits) / static_cast<double>(pairs.triangle_tests);
}

std::vector<QueryMeasure> measure_queries(const Mesh& mesh_a, const Mesh& mesh_b,
                                          std::span<const Pose> poses, int repetitions,
                                          const std::function<void()>& on_pose) {
  std::vector<QueryMeasure> measures;
  for (const Volume volume : kVolumes)
    measures.push_back({volume, 0, 0, {}, {}, 0});
  std::vector<Times> times(measures.size());
  for (const Pose& pose : poses) {
    for (std::size_t i = 0; i < measures.size(); ++i) {
      measure_pose(measures[i], times[i], {mesh_a}, {mesh_b, pose}, repetitions);
      if (measures[i].hits != measures[0].hits) {
        throw Error(std::string("volumes disagree: ") + graze::name_of(measures[i].volume));
      }
    }
    on_pose();
  }
  for (std::size_t i = 0; i < measures.size(); ++i) {
    measures[i].any_microseconds = median(times[i].any);
    measures[i].pairs_microseconds = median(times[i].pairs);
  }
  return measures;
}

}  // namespace graze::benchmark
