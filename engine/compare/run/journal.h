#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <graze/engine/compare/run/comparison.h>

namespace graze::compare {

/// What tells one comparison from another: the meshes, the poses and the question.
std::string key_of(const ComparisonJob& job);

/// One line of JSON for one pose, without its line break.
std::string to_json(const PoseRecord& record);

/// A comparison in a file, a line a pose behind a line that names the job: what a run that was
/// stopped is resumed from, and what a later run is held against.
struct Journal {
  std::string key;
  std::size_t poses = 0;
  std::vector<PoseRecord> records;  ///< in the order of the file
};

/// Throws CaseError, naming file and line. A last line that a stopped run left unfinished is
/// dropped: its pose is asked again.
Journal read_journal(const std::filesystem::path& path);

/// Appends records as they come, each flushed, so that nothing is lost when the run is stopped.
class JournalWriter {
 public:
  /// Begins the file, or with `known` lines rewrites it with these. Throws CaseError.
  JournalWriter(const std::filesystem::path& path, const ComparisonJob& job,
                const std::vector<PoseRecord>& known);
  void add(const PoseRecord& record);

 private:
  std::string name_;
  std::ofstream file_;
};

/// How a run differs from an older one of the same job.
struct BaselineDifference {
  std::vector<std::size_t> changed_poses;  ///< graze's answer has another bit
  std::vector<std::size_t> missing_poses;  ///< one of the two has no answer of graze
  double old_time = 0;  ///< microseconds, graze's sum over the poses that both have
  double new_time = 0;
};

BaselineDifference compare_to_baseline(const Journal& baseline,
                                       const std::vector<PoseRecord>& records);

}  // namespace graze::compare
