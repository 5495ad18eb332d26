#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/run/comparison.h>

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

/// Adds up answers, engine by engine.
class Summaries {
 public:
  void add(const compare::AnswerRecord& answer);

  /// In the order in which engines first answered.
  std::vector<EngineSummary> take() const;

 private:
  std::vector<EngineSummary> summaries_;
  std::vector<std::vector<double>> times_;
};

std::vector<EngineSummary> summarise(std::span<const compare::PoseRecord> records);

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
