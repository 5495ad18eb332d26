#pragma once

#include <graze/engine/record/read_recording.h>
#include <graze/engine/record/replay_recording.h>
#include <graze/engine/record/world_recorder.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graze::tests {

/// A recording in memory.
struct RecordedRun {
  std::string bytes;

  auto sink() {
    return [this](std::string_view more) { bytes += more; };
  }
  RecordingReader reader() const;
};

RecordingReader reader_of(std::string bytes);

/// All updates of it. Throws as the reader does.
std::vector<RecordedStep> steps_of(const std::string& bytes);

/// The first difference that repeating it finds, in words that a failure shows.
std::string first_difference_in(const std::string& bytes,
                                const RecordingReplaySettings& settings = {});

}  // namespace graze::tests
