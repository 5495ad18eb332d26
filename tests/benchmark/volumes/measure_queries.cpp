#include "tests/benchmark/volumes/measure_queries.h"

#include <graze/bvh/error.h>
#include <graze/engine/mesh/pair.h>

#include <string>

#include "tests/benchmark/common/stopwatch.h"
#include "tests/benchmark/volumes/cascade.h"

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

/// A way to ask the two questions.
struct Contestant {
  std::string name;
  std::function<bool(const PlacedMeshView&, const PlacedMeshView&, Work&)> any;
  std::function<TrianglePairs(const PlacedMeshView&, const PlacedMeshView&, Work&)> pairs;
};

std::vector<Contestant> contestants() {
  std::vector<Contestant> all;
  for (const PairVolume volume : kPairVolumes) {
    all.push_back({graze::name_of(volume),
                   [=](const PlacedMeshView& a, const PlacedMeshView& b, Work& work) {
                     return intersects(a, b, {.volume = volume}, &work);
                   },
                   [=](const PlacedMeshView& a, const PlacedMeshView& b, Work& work) {
                     return find_triangle_pairs(a, b, {.volume = volume}, &work);
                   }});
  }
  for (const Volume second : {Volume::Aabb, Volume::Obb, Volume::KDop}) {
    all.push_back({std::string("sphere-") + graze::name_of(second),
                   [=](const PlacedMeshView& a, const PlacedMeshView& b, Work& work) {
                     return intersects_by_cascade(a, b, second, work);
                   },
                   [=](const PlacedMeshView& a, const PlacedMeshView& b, Work& work) {
                     return find_pairs_by_cascade(a, b, second, work);
                   }});
  }
  return all;
}

void measure_pose(const Contestant& contestant, QueryMeasure& measure, Times& times,
                  const PlacedMeshView& a, const PlacedMeshView& b, int repetitions) {
  bool is_hit = contestant.any(a, b, measure.any);  // also warms the caches
  Work ignored;
  times.any.push_back(
      median_microseconds(repetitions, [&] { is_hit &= contestant.any(a, b, ignored); }));
  TrianglePairs found = contestant.pairs(a, b, measure.pairs);
  measure.hits += found.size();
  if (is_hit == found.empty()) throw Error("a boolean query and the pairs disagree");
  times.pairs.push_back(
      median_microseconds(repetitions, [&] { found = contestant.pairs(a, b, ignored); }));
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
  const std::vector<Contestant> all = contestants();
  for (const Contestant& contestant : all)
    measures.push_back({contestant.name, 0, 0, {}, {}, 0});
  std::vector<Times> times(measures.size());
  for (const Pose& pose : poses) {
    for (std::size_t i = 0; i < measures.size(); ++i) {
      measure_pose(all[i], measures[i], times[i], {mesh_a}, {mesh_b, pose}, repetitions);
      if (measures[i].hits != measures[0].hits) {
        throw Error("volumes disagree: " + measures[i].volume);
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
