#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/run/record/answer_record.h>
#include <graze/engine/compare/run/record/step_record.h>
#include <graze/engine/compare/run/record/time_code.h>
#include <graze/engine/compare/run/shrink_worst.h>

namespace graze::cli {

/// Says what one engine did in all places.
struct EngineSummary {
  std::string engine;
  std::size_t answers = 0;
  std::size_t agreed = 0;  ///< answers that nobody contradicted
  std::size_t right = 0;   ///< answers that the referee confirmed
  std::size_t not_judged = 0;
  std::size_t not_confirmed = 0;  ///< answers that were wrong, but not when they were asked again
                                  ///< alone
  std::size_t wrong = 0;
  std::array<std::size_t, compare::kErrorClasses.size()>
      classes{};  ///< the wrong ones by ErrorClass
  std::array<double, compare::kErrorClasses.size()> class_errors{};  ///< metres, the largest
  std::array<double, compare::kErrorClasses.size()> class_ulps{};    ///< ulps, the largest
  double largest_error = 0;                                          ///< metres
  double largest_ulps = 0;
  double median_time = 0;  ///< microseconds
  double total_time = 0;
};

/// Counts what engines did as records come, in memory that does not grow with them.
class Tally {
 public:
  void add(const compare::PlaceRecord& record);
  /// Adds a step of a scene. The median is that of the steps' means.
  void add(const compare::StepRecord& record);

  /// Returns summaries in the order in which engines first answered.
  std::vector<EngineSummary> summaries() const;

  /// Returns "3 wrong of fcl" for those who wait; empty if nothing is wrong yet.
  std::string note() const;

 private:
  struct Counted {
    EngineSummary summary;
    compare::TimeMedian times;
  };

  EngineSummary& add(const std::string& engine, std::size_t answers, double time);

  std::vector<Counted> engines_;
};

/// Returns the wrong answers of all engines in one place; they have no query yet.
std::vector<compare::WrongAnswer> wrong_answers(const compare::PlaceRecord& record);

/// Holds a shrunk case and the file that it went to.
struct WrittenCase {
  compare::ShrunkCase shrunk;
  std::size_t place = 0;
  std::string where;  ///< the name of the place, for people
  std::string file;
  std::string says = {};   ///< the engine's answer to the shrunk case, in a few characters
  std::string least = {};  ///< says that it cannot be smaller, where it is more than two triangles
  bool is_written = true;
  bool is_recorded = false;  ///< true if it is the whole of a query that was answered elsewhere
};

/// Returns a table of the first of `count` wrong answers, one by one; `place` is "pose", "case".
std::string wrong_rows(std::span<const compare::WrongAnswer> first, std::size_t count,
                       const std::string& place);

/// Returns a line for each engine.
std::string summary_text(std::span<const EngineSummary> summaries);

/// Returns one JSON object on one line: {"summary":[...],"cases":[...]}.
std::string summary_json(std::span<const EngineSummary> summaries,
                         std::span<const WrittenCase> cases, const std::string& place);

}  // namespace graze::cli
