#pragma once

#include <span>
#include <string>
#include <vector>

#include <graze/engine/cli/output/output.h>
#include <graze/engine/cli/replay/fail_on.h>
#include <graze/engine/cli/reports/table.h>
#include <graze/engine/compare/run/trial.h>

namespace graze::cli {

/// Prints who said what to each case: a table for people, or one JSON object a case.
class ReplayReport {
 public:
  /// Keeps `fail_on`, which must outlive it.
  ReplayReport(Output& output, const FailOn& fail_on, bool is_json);

  void begin(std::span<const compare::EngineEntry> engines);
  void add(const std::string& file, const Case& query,
           const std::vector<compare::Testimony>& testimonies);
  void end();

  /// True if graze is wrong today, by the referee.
  bool is_graze_wrong() const { return graze_wrong_ > 0; }
  /// True if an answer of graze is another than the recorded one of graze or the referee.
  bool has_changed() const { return changed_ > 0; }
  /// True if no referee says which of two such answers is right.
  bool has_changed_unjudged() const { return changed_unjudged_ > 0; }
  /// Returns how many wrong answers `fail_on` names.
  std::size_t failures() const { return failures_; }

 private:
  Output& output_;
  const FailOn& fail_on_;
  bool is_json_;
  std::vector<std::string> engines_;  ///< the names of engines that are here
  Table table_;
  std::size_t cases_ = 0;
  std::size_t graze_wrong_ = 0;
  std::size_t changed_ = 0;
  std::size_t changed_unjudged_ = 0;
  std::size_t failures_ = 0;
};

/// Returns a JSON object: {"engine":...,"verdict":...}; "fails" stands in it where `fail_on` names
/// the answer.
std::string to_json(const compare::Testimony& testimony, const FailOn& fail_on);

}  // namespace graze::cli
