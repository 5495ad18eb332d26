#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::cli {

struct ReplayOptions {
  std::vector<std::string> files = {};  ///< files or folders: see case_files()
  std::string mesh_folder = {};  ///< the folder of meshes by file; empty for that of each case
  bool is_json = false;
  bool has_progress = false;
  std::vector<std::string> engine_commands = {};  ///< commands, each of which starts an engine of
                                                  ///< the user's own
  double timeout = 60;                            ///< seconds for each question to another engine
  bool is_change_failure = false;  ///< true if an answer other than the recorded one is exit code 1
  std::vector<std::string> fail_on = {};  ///< says whose wrong answers are, too (FailOn)
};

/// Reads all cases before the first is asked. Cases that cannot be read are named, one line each on
/// stderr, and the others are replayed; the exit code is then BadInput. Where no case is left,
/// standard output stays empty; a refusal that is the only one is thrown as a CaseError. Throws
/// UsageError for what `fail_on` cannot mean.
ExitCode run_replay(const ReplayOptions& options, std::span<const compare::EngineEntry> engines,
                    Output& output);

}  // namespace graze::cli
