#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/error/contestant.h"

namespace graze::benchmark {

/// Distinct elements of one kind with the truth about them.
template <typename Element>
struct Category {
  std::string name;
  bool is_generic;       ///< general position, ordinary size
  bool has_only_floats;  ///< every coordinate is a float
  std::vector<Element> elements;
  std::vector<bool> truth;
  std::size_t refereed;  ///< of these, settled or confirmed by the referee
};

struct Sizes {
  std::size_t elements = 20000;  ///< of each category
  std::size_t refereed = 400;    ///< of these, checked by the exact referee
  std::size_t distances = 1000;  ///< of each category of distances
  std::size_t boxes = 4000;      ///< of each category of oriented boxes
  std::size_t motions = 1000;    ///< of each category of straight paths
};

/// How one contestant did in one category.
struct Score {
  double nanoseconds = 0;  ///< per element, median of the repetitions
  std::size_t false_positives = 0;
  std::size_t false_negatives = 0;
  std::size_t unsure = 0;
  std::size_t failed = 0;

  std::size_t errors() const { return false_positives + false_negatives + unsure + failed; }
};

/// Elements that are read into the cache at once, answered next: small enough for a second-level
/// cache, and never the same again within a repetition, so that no branch predictor learns them.
inline constexpr std::size_t kChunk = 1024;

inline void count(Score& score, Answer answer, bool truth) {
  score.false_positives += answer == Answer::Touching && !truth;
  score.false_negatives += answer == Answer::Apart && truth;
  score.unsure += answer == Answer::Unsure;
  score.failed += answer == Answer::Failed;
}

/// Nanoseconds that all elements take.
template <typename Element, typename Reply>
double timed_run(Contestant<Element, Reply>& contestant, std::span<Reply> answers) {
  double nanoseconds = 0;
  for (std::size_t first = 0; first < answers.size(); first += kChunk) {
    const std::size_t size = std::min(kChunk, answers.size() - first);
    contestant.warm(first, size);
    const ThreadClock clock;
    contestant.answer(first, answers.subspan(first, size));
    nanoseconds += clock.nanoseconds();
  }
  return nanoseconds;
}

/// The indices below `size`, in an order that depends on `seed` alone: Fisher and Yates's shuffle,
/// with Knuth's linear congruential generator.
inline std::vector<std::size_t> shuffled_indices(std::size_t size, std::uint64_t seed) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t left = size; left > 1; --left) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    std::swap(order[left - 1], order[(seed >> 33) % left]);
  }
  return order;
}

/// Nanoseconds per element of each contestant, medians of the repetitions. They take turns in each
/// repetition, so that a slow moment of the machine hits all of them, and in another order each
/// time, so that nobody always comes after the one who taught the branch predictor. `see(i,
/// answers)` is called with what contestant i answers in the first repetition.
template <typename Element, typename Reply, typename See>
std::vector<double> take_turns(std::span<const Element> elements,
                               const Contestants<Element, Reply>& contestants, int repetitions,
                               const See& see) {
  std::vector<Reply> answers(elements.size());
  std::vector<std::vector<double>> times(contestants.size());
  for (const auto& contestant : contestants)
    contestant->prepare(elements);
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    const auto seed = static_cast<std::uint64_t>(repetition) + 1;
    for (const std::size_t i : shuffled_indices(contestants.size(), seed)) {
      const double time = timed_run<Element, Reply>(*contestants[i], answers);
      times[i].push_back(time / static_cast<double>(elements.size()));
      if (repetition == 0) see(i, std::span<const Reply>(answers));
    }
  }
  std::vector<double> medians;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    contestants[i]->release();
    medians.push_back(median(times[i]));
  }
  return medians;
}

/// Scores in the order of the contestants.
template <typename Element>
std::vector<Score> contest(const Category<Element>& category,
                           const Contestants<Element>& contestants, int repetitions) {
  std::vector<Score> scores(contestants.size());
  const std::vector<double> times =
      take_turns(std::span<const Element>(category.elements), contestants, repetitions,
                 [&](std::size_t i, std::span<const Answer> answers) {
                   for (std::size_t k = 0; k < answers.size(); ++k)
                     count(scores[i], answers[k], category.truth[k]);
                 });
  for (std::size_t i = 0; i < contestants.size(); ++i)
    scores[i].nanoseconds = times[i];
  return scores;
}

}  // namespace graze::benchmark
