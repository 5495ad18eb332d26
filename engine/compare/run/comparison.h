#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/answer_record.h>

namespace graze::compare {

/// Two meshes in many poses of B, and one question.
struct ComparisonJob {
  CaseMesh a;
  CaseMesh b;  ///< its pose is not used
  std::vector<Pose> poses_b;
  /// Where B goes from each of the poses, of Ask::FirstContact and Free; of other questions none.
  std::vector<RigidCourse> courses_b = {};
  Question question;
  std::size_t threads = 0;  ///< 0: as many as there are processors
};

/// The case that asks the question in one pose.
Case case_of(const ComparisonJob& job, std::size_t pose);

/// Puts the question to all engines that are here, in every pose that `is_done` does not know, and
/// lets the referee settle every difference; distances and times, for which differences are the
/// rule, always. `on_record` is called as poses are finished, by one thread at a time and in no
/// order.
void run_comparison(const ComparisonJob& job, std::span<const EngineEntry> engines,
                    const std::function<bool(std::size_t)>& is_done,
                    const std::function<void(PlaceRecord)>& on_record);

}  // namespace graze::compare
