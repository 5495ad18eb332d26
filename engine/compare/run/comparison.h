#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// What one engine answered in one pose.
struct AnswerRecord {
  std::string engine;
  std::string digest;      ///< SHA-256 of the answer as JSON: equal for equal answers, bit for bit
  std::string brief;       ///< the answer in a few characters
  double time = 0;         ///< microseconds
  bool is_agreed = false;  ///< no engine contradicted, so that the referee was not asked
  Judgement judgement;

  bool is_wrong() const { return judgement.verdict == Verdict::Wrong; }
};

/// What all of them answered in one pose of B.
struct PoseRecord {
  std::size_t pose = 0;  ///< counted from 0
  std::vector<AnswerRecord> answers;
};

/// Two meshes in many poses of B, and one question.
struct ComparisonJob {
  CaseMesh a;
  CaseMesh b;  ///< its pose is not used
  std::vector<Pose> poses_b;
  Question question;
  std::size_t threads = 0;  ///< 0: as many as there are processors
};

/// The case that asks the question in one pose.
Case case_of(const ComparisonJob& job, std::size_t pose);

/// Puts the question to all engines that are here, in every pose that `is_done` does not know, and
/// lets the referee settle every difference; a distance, for which differences are the rule,
/// always. `on_record` is called as poses are finished, by one thread at a time and in no order.
void run_comparison(const ComparisonJob& job, std::span<const EngineEntry> engines,
                    const std::function<bool(std::size_t)>& is_done,
                    const std::function<void(PoseRecord)>& on_record);

/// A wrong answer as small as it could be made, with what the referee says of that.
struct ShrunkCase {
  std::string engine;
  std::size_t pose = 0;
  Case query;  ///< with the engine's wrong answer
  Judgement judgement;
};

/// Shrinks the `limit` worst wrong answers: those of graze first, then by their class, then in the
/// order of poses. What cannot be shown again is left as it is.
std::vector<ShrunkCase> shrink_worst(const ComparisonJob& job, std::span<const EngineEntry> engines,
                                     std::span<const PoseRecord> records, std::size_t limit);

}  // namespace graze::compare
