#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <graze/engine/compare/run/record/answer_record.h>
#include <graze/engine/scenes/scene.h>

namespace graze::compare {

/// Holds what one engine did at one step. "world" is a graze::World that steps the scene, with all
/// that it remembers and skips; "graze" is asked about each pair alone, as the others are.
struct StepAnswers {
  std::string engine;
  std::size_t answers = 0;
  std::string digest;  ///< the SHA-256 of all that it said: equal for equal answers
  double time = 0;     ///< microseconds for all pairs together
};

/// Holds a pair of bodies of which not all engines said the same, or of which the world should not
/// speak.
struct SceneDifference {
  ScenePair pair;
  std::vector<AnswerRecord> answers;  ///< the answer of "world" first
};

/// Holds what all engines said about all pairs at one step.
struct StepRecord {
  std::size_t place = 0;  ///< the step
  double time = 0;        ///< seconds
  std::size_t questions = 0;
  std::vector<StepAnswers> engines;  ///< the engines, "world" first
  std::vector<SceneDifference> differences;
};

/// Returns one line of JSON, without its line break.
std::string to_json(const StepRecord& record);

/// Reads the same from JSON, for a scene with so many bodies. Throws CaseError.
StepRecord read_step_record(const cases::JsonCursor& at, const ExpectedPlace& expected,
                            std::size_t bodies);

/// Returns what each said, and "world" and "graze" together, under the name of graze.
std::vector<SaidThere> said_there(const StepRecord& record);

}  // namespace graze::compare
