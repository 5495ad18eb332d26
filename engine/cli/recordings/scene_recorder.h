#pragma once

#include <optional>
#include <string>

#include <graze/engine/record/world_recorder.h>
#include <graze/engine/scenes/simulation.h>

namespace graze::cli {

/// Writes what a simulation of a scene does, if it is asked to.
class SceneRecorder {
 public:
  /// Writes nothing if there is no file. `simulation` has not advanced yet. Throws as WorldRecorder
  /// does.
  SceneRecorder(const std::optional<std::string>& file, const Scene& scene, Simulation& simulation,
                RecordedContacts contacts);

  /// Throws what went wrong so far.
  void check();
  /// Ends the file. Throws as WorldRecorder::finish() does.
  void finish();

 private:
  std::optional<WorldRecorder> recorder_;
};

}  // namespace graze::cli
