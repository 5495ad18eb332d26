#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/line_file.h>

namespace graze::compare {

/// What tells one comparison from another: the meshes, the poses, the question and its settings.
std::string key_of(const ComparisonJob& job);

/// SHA-256 of a mesh's vertices and triangles, with `before` in front.
std::string digest_of(const Mesh& mesh, const std::string& before);

/// One line of JSON for one pose, without its line break.
std::string to_json(const PoseRecord& record);

/// A comparison in a file, a line a pose behind a line that names the job: what a run that was
/// stopped is resumed from, and what a later run is held against.
struct Journal {
  std::string key;
  std::vector<std::string> engines;  ///< that were asked
  std::size_t poses = 0;
  std::vector<PoseRecord> records;  ///< in the order of the file
};

/// Throws CaseError, naming file and line. A last line that a stopped run left unfinished is
/// dropped: its pose is asked again.
Journal read_journal(const std::filesystem::path& path);

/// Appends records as they come, so that nothing is lost when the run is stopped.
class JournalWriter {
 public:
  /// Begins the file, or with `known` lines rewrites it with these. Throws CaseError.
  JournalWriter(const std::filesystem::path& path, const ComparisonJob& job,
                std::span<const EngineEntry> engines, const std::vector<PoseRecord>& known);
  void add(const PoseRecord& record) { file_.add(to_json(record)); }

 private:
  LineFile file_;
};

/// How a run differs from an older one of the same job.
struct BaselineDifference {
  std::vector<std::size_t> changed;  ///< poses, or steps: graze's answer has another bit
  std::vector<std::size_t> missing;  ///< one of the two has no answer of graze
  double old_time = 0;               ///< microseconds, graze's sum over what both have
  double new_time = 0;
};

BaselineDifference compare_to_baseline(const Journal& baseline,
                                       const std::vector<PoseRecord>& records);

}  // namespace graze::compare
