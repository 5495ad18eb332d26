#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/cli/compare_run.h>
#include <graze/engine/compare/run/journal.h>

namespace graze::cli {

/// Throws UsageError if a file that is to be written has no folder: before a long run, not after.
void check_places(const CompareOptions& options);

/// Throws UsageError if a record that is to be gone on with is of another job, or of other engines.
void check_resumed(const CompareOptions& options, bool is_same_job,
                   std::span<const std::string> engines_then,
                   std::span<const compare::EngineEntry> engines_now);

/// Throws UsageError if the baseline is of another job.
void check_baseline(const CompareOptions& options, bool is_same_job);

/// What is said of an older run, and whether that is a regression.
struct Regression {
  bool is_one = false;
  std::string text;
};

/// `places` are "poses" or "steps".
Regression regression_of(const CompareOptions& options, const compare::BaselineDifference& found,
                         std::string_view places);

}  // namespace graze::cli
