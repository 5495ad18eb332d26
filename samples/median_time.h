#pragma once

#include <algorithm>
#include <array>
#include <chrono>

namespace graze::samples {

/// The median of three runs, after one that warms caches and builds what is built lazily.
template <typename Function>
double median_microseconds(const Function& function) {
  function();
  std::array<double, 3> times;
  for (double& time : times) {
    const auto start = std::chrono::steady_clock::now();
    function();
    time =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  }
  std::ranges::nth_element(times, times.begin() + times.size() / 2);
  return times[times.size() / 2];
}

}  // namespace graze::samples
