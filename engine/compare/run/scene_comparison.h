#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/scenes/scene.h>

namespace graze::compare {

struct SceneComparisonSettings {
  std::size_t steps = 0;  ///< after step 0
  double step = 0;        ///< seconds; 0: as the scene says
};

/// What all engines said of one pair of bodies at one step. The first answer is that of "world", a
/// graze::World that steps the scene, with all that it remembers and skips; "graze" is asked about
/// the pair alone, as the others are.
struct SceneRecord {
  std::size_t step = 0;
  double time = 0;  ///< seconds
  ScenePair pair;
  std::span<const AnswerRecord> answers;  ///< valid during the call
};

/// Steps the scene, puts every pair of bodies that a world looks at to every engine that knows
/// such shapes, and has each difference judged (ShapeJudge). That the world and graze alone differ
/// is wrong of the world, whoever else is right: hierarchies and memory change nothing (law 9).
/// Throws what Simulation throws.
void compare_scene(const Scene& scene, std::span<const EngineEntry> engines,
                   const SceneComparisonSettings& settings,
                   const std::function<void(const SceneRecord&)>& on_record);

/// The question about two meshes of the scene at a time, as a job of one pose.
ComparisonJob mesh_job(const Scene& scene, const ScenePair& pair, double time);

}  // namespace graze::compare
