#pragma once

#include <vector>

#include "tests/benchmark/common/thread_clock.h"

namespace graze::benchmark {

/// Microseconds of this thread's processor time that a query takes: the median of `repetitions`,
/// each of as many runs as make the clock count for little, after one that warms the caches. One
/// that takes long is not repeated.
template <typename Query>
double microseconds_of(int repetitions, const Query& query) {
  constexpr double kLong = 20000;  // microseconds
  constexpr double kEnough = 50;   // microseconds, of which the clock takes a hundredth
  constexpr int kMostRuns = 1024;
  const ThreadClock first;
  query();
  const double once = first.nanoseconds() / 1000;
  if (once > kLong) return once;
  const auto time_of = [&](int runs) {
    const ThreadClock clock;
    for (int i = 0; i < runs; ++i)
      query();
    return clock.nanoseconds() / 1000;
  };
  int runs = 1;
  while (runs < kMostRuns && time_of(runs) < kEnough)
    runs *= 2;
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i)
    times.push_back(time_of(runs) / runs);
  return median(times);
}

}  // namespace graze::benchmark
