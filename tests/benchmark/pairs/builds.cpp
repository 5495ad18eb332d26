#include "tests/benchmark/pairs/builds.h"

#include <malloc.h>

#include <algorithm>

#include "tests/benchmark/common/stopwatch.h"
#include "tests/benchmark/common/thread_clock.h"

namespace graze::benchmark {
namespace {

std::size_t heap_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

template <typename Build>
double milliseconds_of(PairContestant& contestant, const BuildSettings& settings,
                       const Build& build) {
  std::vector<double> times;
  for (int i = 0; i < settings.repetitions; ++i) {
    contestant.release();
    const Stopwatch watch;
    const ThreadClock clock;
    build();
    const bool is_alone = settings.threads == 1;
    times.push_back(is_alone ? clock.nanoseconds() / 1e6 : watch.microseconds() / 1e3);
  }
  return median(times);
}

}  // namespace

BuildMeasure measure_build(PairContestant& contestant, const Scene& scene,
                           const BuildSettings& settings) {
  const Mesh& a = scene.mesh_a;
  const Mesh& b = scene.mesh_b;
  BuildMeasure measure;
  for (const RegimePoses& regime : scene.regimes) {
    measure.one_shot[regime.name] = milliseconds_of(
        contestant, settings, [&] { contestant.any_once(a, b, regime.poses.front()); });
  }
  contestant.release();
  const std::size_t before = heap_bytes();
  measure.milliseconds = milliseconds_of(contestant, settings, [&] { contestant.build(a, b); });
  const std::size_t after = heap_bytes();
  measure.bytes = contestant.bytes().value_or(after - std::min(before, after));
  return measure;
}

}  // namespace graze::benchmark
