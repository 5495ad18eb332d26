#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

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

/// The upper median of at least one value.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace graze::benchmark
