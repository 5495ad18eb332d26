#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <graze/engine/compare/run/journal.h>
#include <graze/engine/compare/run/scene_comparison.h>

namespace graze::compare {

/// What tells one comparison of a scene from another.
struct SceneJob {
  std::string key;  ///< of the file's bytes, its meshes, and the length of a step
  std::size_t steps = 0;
  friend bool operator==(const SceneJob&, const SceneJob&) = default;
};

/// Throws SceneError if the file cannot be read.
SceneJob scene_job(const std::filesystem::path& file, const Scene& scene,
                   const SceneComparisonSettings& settings);

/// A comparison of a scene in a file, a line a step behind a line that names the job.
struct SceneJournal {
  SceneJob job;
  std::vector<std::string> engines;  ///< that were asked
  std::vector<StepRecord> records;   ///< in the order of the file
};

/// Throws CaseError, naming file and line. `scene` is what the pairs are of. A last line that a
/// stopped run left unfinished is dropped: its step is asked again.
SceneJournal read_scene_journal(const std::filesystem::path& path, const Scene& scene);

/// Appends records as they come, so that nothing is lost when the run is stopped.
class SceneJournalWriter {
 public:
  /// Begins the file, or with `known` lines rewrites it with these. Throws CaseError.
  SceneJournalWriter(const std::filesystem::path& path, const SceneJob& job,
                     std::span<const EngineEntry> engines, const std::vector<StepRecord>& known);
  void add(const StepRecord& record);

 private:
  LineFile file_;
};

/// By "world" and "graze", step by step.
BaselineDifference compare_to_baseline(const SceneJournal& baseline,
                                       const std::vector<StepRecord>& records);

}  // namespace graze::compare
