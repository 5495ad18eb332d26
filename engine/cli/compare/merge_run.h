#pragma once

#include <string>
#include <vector>

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>

namespace graze::cli {

/// Holds the arguments of `graze merge` as they are given.
struct MergeOptions {
  std::vector<std::string> parts;         ///< records of `graze compare --part`
  std::string save = {};                  ///< the record of all parts; empty for none
  std::vector<std::string> fail_on = {};  ///< says whose wrong answers fail the merge (FailOn)
  std::string junit = {};                 ///< an XML file for programs that run tests
  std::string markdown = {};              ///< a file for a code host's summary
  bool is_json = false;
  bool has_progress = false;
};

/// Puts the parts of one comparison together and says what one run of it would say, without asking
/// any engine. Throws CaseError, naming the file, for a part that is missing, doubled, incomplete,
/// damaged or of another job, and UsageError for outputs that cannot be.
ExitCode run_merge(const MergeOptions& options, Output& output);

}  // namespace graze::cli
