#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/scenes/scene.h>

namespace graze::compare {

struct SceneComparisonSettings {
  std::size_t steps = 0;    ///< after step 0
  double step = 0;          ///< seconds; 0: as the scene says
  std::size_t threads = 0;  ///< 0: as many as there are processors
};

/// What one engine did at one step. "world" is a graze::World that steps the scene, with all that
/// it remembers and skips; "graze" is asked about each pair alone, as the others are.
struct StepAnswers {
  std::string engine;
  std::size_t answers = 0;
  std::string digest;  ///< SHA-256 of all that it said: equal for equal answers
  double time = 0;     ///< microseconds, all pairs together
};

/// A pair of bodies of which not all engines said the same, or of which the world should not speak.
struct SceneDifference {
  ScenePair pair;
  std::vector<AnswerRecord> answers;  ///< that of "world" first
};

/// All engines about all pairs at one step.
struct StepRecord {
  std::size_t step = 0;
  double time = 0;  ///< seconds
  std::size_t questions = 0;
  std::vector<StepAnswers> engines;  ///< "world" first
  std::vector<SceneDifference> differences;
};

/// Steps the scene, puts every pair of bodies that a world looks at to every engine that knows
/// such shapes, and has each difference judged (ShapeJudge). That the world and graze alone differ
/// is wrong of the world, whoever else is right: hierarchies and memory change nothing (law 9).
/// Of steps that `is_done` knows nothing is asked; the world goes through them all the same, for
/// what it remembers is on trial. `on_record` is called as steps are finished, by one thread at a
/// time and in no order. Throws what Simulation throws.
void compare_scene(const Scene& scene, std::span<const EngineEntry> engines,
                   const SceneComparisonSettings& settings,
                   const std::function<bool(std::size_t)>& is_done,
                   const std::function<void(StepRecord)>& on_record);

/// The question about two meshes of the scene at a time, as a job of one pose.
ComparisonJob mesh_job(const Scene& scene, const ScenePair& pair, double time);

}  // namespace graze::compare
