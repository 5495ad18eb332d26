#include "tests/engine/record/recorded_run.h"

#include <memory>
#include <sstream>

namespace graze::tests {

RecordingReader reader_of(std::string bytes) {
  return {std::make_unique<std::istringstream>(std::move(bytes)), "run.recording"};
}

RecordingReader RecordedRun::reader() const {
  return reader_of(bytes);
}

std::vector<RecordedStep> steps_of(const std::string& bytes) {
  RecordingReader reader = reader_of(bytes);
  std::vector<RecordedStep> steps;
  while (const RecordedStep* step = reader.next())
    steps.push_back(*step);
  return steps;
}

std::string first_difference_in(const std::string& bytes, const RecordingReplaySettings& settings) {
  RecordingReplay replay(reader_of(bytes), settings);
  while (replay.advance()) {
    const std::optional<RecordingDifference>& found = replay.difference();
    if (!found) continue;
    std::string text = "update " + std::to_string(found->update) + ": " + found->what;
    if (found->pair) {
      text += " of " + std::to_string(found->pair->a.index) + " and " +
              std::to_string(found->pair->b.index);
    }
    return text + ": " + found->first + " / " + found->second;
  }
  return "none";
}

}  // namespace graze::tests
