#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/cli/compare/compare_report.h>
#include <graze/engine/cli/compare/compare_run.h>
#include <graze/engine/cli/compare/wrong_list.h>
#include <graze/engine/compare/run/record/baseline.h>
#include <graze/engine/compare/run/record/journal.h>
#include <graze/engine/compare/run/shrink_worst.h>

namespace graze::cli {

/// Throws UsageError or FileError before a long run, not after it, if a file that is to be written
/// cannot be, or is also an input or another output, and for what --fail-on cannot mean.
void check_before(const CompareOptions& options, std::span<const compare::EngineEntry> field);

/// Returns an empty list of the wrong answers of a run among these engines, as --keep and --fail-on
/// want them.
WrongList wrong_list_of(const CompareOptions& options, std::span<const compare::EngineEntry> field);

/// Throws UsageError if a record that is to be gone on with is of another job, or of other engines.
void check_resumed(const CompareOptions& options, const compare::JournalHead& head,
                   const compare::JournalHead& record);

/// Throws UsageError if the baseline is of another job.
void check_baseline(const CompareOptions& options, const compare::JournalHead& head,
                    const compare::JournalHead& record);

/// Says how far an interrupted run came, and how to go on.
std::string interruption_text(const CompareOptions& options, const compare::JournalHead& head,
                              std::size_t done);

/// Holds what a comparison has found, of whatever kind it is.
struct CompareFindings {
  std::string title;                    ///< a title in notes of cases: "bolt.obj against nut.stl"
  std::string question;                 ///< the question; empty if each case says it
  std::string count;                    ///< "12 poses"
  std::string place;                    ///< what one of them is called: "pose"
  std::vector<std::string> names = {};  ///< names of places, for people; empty if they are numbers
  std::string rows = {};                ///< the rows of the table of what is wrong, or differs
  std::string json = {};                ///< lines before the summary that are not written yet
  std::vector<EngineSummary> summaries;
  WrongList wrong;
  std::optional<std::vector<compare::EngineChange>> changes = {};  ///< the changes since the run of
                                                                   ///< --against
  std::vector<compare::JournalPart> asked = {};                    ///< the job that was asked
};

/// Shrinks the worst answers of the engines that took part to cases, writes these and the report,
/// and prints what was found; `engines` are all that there are. GrazeWrong if graze is wrong
/// anywhere, or other than it was, or for a wrong answer that --fail-on names. Cases that cannot be
/// written are named on stderr, and make BadInput of what else would be Answered if their folder
/// was asked for.
ExitCode conclude(const CompareOptions& options, std::span<const compare::EngineEntry> engines,
                  std::span<const compare::EngineEntry> field, const CompareFindings& findings,
                  Output& output);

}  // namespace graze::cli
