#pragma once

#include <optional>
#include <string>

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>

namespace graze::cli {

/// What `graze replay` is told of a recording.
struct RecordingOptions {
  std::string file;
  std::optional<std::string> against = {};  ///< another recording; else it is repeated
  int threads = 1;                          ///< of the repetition
  bool has_work = false;                    ///< compares work counters, too
  bool is_json = false;
  bool has_progress = false;
};

/// Repeats a recording, or puts another one beside it, and names the first update and pair that
/// differ. GrazeWrong if any does. Throws RecordingError for what cannot be read.
ExitCode run_recording(const RecordingOptions& options, Output& output);

}  // namespace graze::cli
