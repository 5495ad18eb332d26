#pragma once

#include <chrono>

#include "tests/benchmark/common/median.h"

namespace graze::benchmark {

class Stopwatch {
 public:
  double microseconds() const {
    return std::chrono::duration<double, std::micro>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace graze::benchmark
