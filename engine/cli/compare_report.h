#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/scene_comparison.h>

namespace graze::cli {

/// What one engine did in all poses.
struct EngineSummary {
  std::string engine;
  std::size_t answers = 0;
  std::size_t agreed = 0;  ///< nobody contradicted
  std::size_t right = 0;   ///< the referee confirmed
  std::size_t not_judged = 0;
  std::size_t wrong = 0;
  std::array<std::size_t, 5> classes{};  ///< of the wrong ones, by ErrorClass
  double largest_error = 0;              ///< metres
  double largest_ulps = 0;
  double median_time = 0;  ///< microseconds
  double total_time = 0;
};

/// In the order in which engines first answered.
std::vector<EngineSummary> summarise(std::span<const compare::PoseRecord> records);

/// Of a scene. The median is that of the steps' means.
std::vector<EngineSummary> summarise(std::span<const compare::StepRecord> records);

/// A wrong answer and the pose, or the step and the bodies, where it was given.
struct WrongAnswer {
  std::string where;
  const compare::AnswerRecord* answer;
};

/// Of all engines, in the order of poses. They refer to the records.
std::vector<WrongAnswer> wrong_answers(std::span<const compare::PoseRecord> records);

/// A shrunk case and the file that it went to.
struct WrittenCase {
  compare::ShrunkCase shrunk;
  std::string file;
};

/// Tables for people: wrong answers one by one, then a line an engine.
std::string compare_text(std::span<const compare::PoseRecord> records,
                         std::span<const WrittenCase> cases);

/// A line an engine.
std::string summary_text(std::span<const EngineSummary> summaries);

/// One JSON object on one line: {"summary":[...],"cases":[...]}.
std::string summary_json(std::span<const EngineSummary> summaries,
                         std::span<const WrittenCase> cases);

}  // namespace graze::cli
