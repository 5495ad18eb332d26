#pragma once

#include <optional>
#include <string>

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>

namespace graze::cli {

/// Says what `graze replay` is told of a recording.
struct RecordingOptions {
  std::string file;
  std::optional<std::string> against = {};  ///< another recording; without it the first is repeated
  int threads = 1;                          ///< threads of the repetition
  bool has_work = false;                    ///< true to compare work counters, too
  bool is_json = false;
  bool has_progress = false;
};

/// Repeats a recording, or puts another one beside it, and names the first update and pair that
/// differ. GrazeWrong if any does. Throws RecordingError for a recording that cannot be read.
ExitCode run_recording(const RecordingOptions& options, Output& output);

}  // namespace graze::cli
