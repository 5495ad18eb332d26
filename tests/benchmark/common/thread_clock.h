#pragma once

#include <ctime>

#include "tests/benchmark/common/median.h"

namespace graze::benchmark {

/// Processor time of this thread: what others take on the machine does not count.
class ThreadClock {
 public:
  double nanoseconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
  }

  double start_ = now();
};

}  // namespace graze::benchmark
