#pragma once

#include <graze/engine/work.h>

#include <cstddef>
#include <vector>

#include "tests/benchmark/motion/paths.h"

namespace graze::benchmark {

enum class Question { Any, Pairs, Distance, Within };
inline constexpr Question kQuestions[] = {Question::Any, Question::Pairs, Question::Distance,
                                          Question::Within};
const char* name_of(Question question);

struct MotionSettings {
  int repetitions = 5;      ///< of each path, of which the median counts
  double clearance = 0.01;  ///< of Question::Within, a share of the scene's size
};

/// One question all along one path, asked with a memory that is new in its first pose, and without.
struct PathTimes {
  std::size_t queries;
  double cold_microseconds;  ///< of each, in the mean
  double remembering_microseconds;
};

struct MotionResult {
  Question question;
  std::size_t queries = 0;
  std::size_t wrong = 0;  ///< answers with a memory that are not those without, to the last bit
  std::vector<PathTimes> paths;
  Work cold;  ///< summed over all queries
  Work remembering;
};

/// Asks both ways in turn, in this thread.
MotionResult measure_motion(const Scene& scene, const std::vector<Path>& paths, Question question,
                            const MotionSettings& settings);

}  // namespace graze::benchmark
