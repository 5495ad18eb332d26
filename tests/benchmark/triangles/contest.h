#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

namespace graze::benchmark {

/// Elements of one kind, distinct ones: with few repeated ones a CPU learns their branches.
template <typename Element>
struct Set {
  std::string name;
  std::vector<Element> elements;
};

/// A way to answer: prepares what it wants of a set, untimed, and then answers all of it.
template <typename Element>
class Contestant {
 public:
  virtual ~Contestant() = default;
  virtual std::string name() const = 0;
  virtual void prepare(const std::vector<Element>& elements) = 0;
  /// hits[i] becomes 1 or 0.
  virtual void answer(std::vector<std::uint8_t>& hits) = 0;
};

/// One row of the table.
struct Score {
  std::string set;
  std::string contestant;
  std::size_t elements;
  double hit_share;
  double exact_share;  ///< of elements that the triage leaves to the exact stage
  double nanoseconds;  ///< per element, median of the repetitions
  std::size_t wrong;   ///< against the exact stage
};

/// What is true of a set, by the exact stage, and how much of it the triage leaves to that.
struct Truth {
  std::vector<std::uint8_t> hits;
  std::size_t exact = 0;
};

/// Processor time of this thread: that of others on the machine does not count.
inline double nanoseconds_so_far() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

/// Runs all contestants in turn, as often as asked, so that a drift of the machine meets all.
template <typename Element, typename Contestants>
std::vector<Score> contest(const Set<Element>& set, const Contestants& contestants,
                           const Truth& truth, int repetitions) {
  const std::size_t count = set.elements.size();
  std::vector<std::vector<double>> times(contestants.size());
  std::vector<std::size_t> wrong(contestants.size());
  std::vector<std::uint8_t> hits(count);
  for (const auto& contestant : contestants)
    contestant->prepare(set.elements);
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const double start = nanoseconds_so_far();
      contestants[i]->answer(hits);
      times[i].push_back((nanoseconds_so_far() - start) / static_cast<double>(count));
      wrong[i] = 0;
      for (std::size_t n = 0; n < count; ++n)
        wrong[i] += hits[n] != truth.hits[n];
    }
  }
  std::vector<Score> scores;
  const auto all_hits = static_cast<double>(std::count(truth.hits.begin(), truth.hits.end(), 1));
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    std::nth_element(times[i].begin(), times[i].begin() + repetitions / 2, times[i].end());
    scores.push_back({set.name, contestants[i]->name(), count,
                      all_hits / static_cast<double>(count),
                      static_cast<double>(truth.exact) / static_cast<double>(count),
                      times[i][static_cast<std::size_t>(repetitions / 2)], wrong[i]});
  }
  return scores;
}

}  // namespace graze::benchmark
