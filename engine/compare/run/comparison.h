#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/compare/run/record/answer_record.h>
#include <graze/engine/compare/run/trial_threads.h>

namespace graze::compare {

/// Holds two meshes, or two bodies, in many poses of B, and one question.
struct ComparisonJob {
  CaseShape a;
  CaseShape b;  ///< the same kind as A; its pose is not used
  std::shared_ptr<const PoseSource> poses_b;
  Question question;  ///< the question; in Ask::FirstContact and Free B goes from each of the poses
                      ///< to the next

  /// Returns how many times the question is asked.
  std::size_t places() const;
  /// Returns where B goes from a pose; nothing for questions that are not about motions.
  std::optional<RigidCourse> course_b(std::size_t pose) const;
};

/// Returns where A stands.
const Pose& pose_a(const ComparisonJob& job);

/// Returns the case that asks the question in one pose.
Case case_of(const ComparisonJob& job, std::size_t pose);

/// Puts the question to all engines that are here, in the poses of the range, and lets the referee
/// settle every difference; distances, times and contacts, which differ as a rule, always.
/// Engines whose answers were recorded are heard as they once answered. `on_records` is called with
/// the records in the order of poses, some at a time, by one thread at a time; once it returns
/// false no other pose is begun. Memory does not grow with the poses.
void run_comparison(const ComparisonJob& job, std::span<const EngineEntry> engines,
                    const PlaceRange& range,
                    const std::function<bool(std::vector<PlaceRecord>)>& on_records);

}  // namespace graze::compare
