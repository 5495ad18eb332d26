#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/record/step_record.h>
#include <graze/engine/compare/run/trial_threads.h>
#include <graze/engine/scenes/scene.h>

namespace graze::compare {

struct SceneComparisonSettings {
  std::size_t steps = 0;  ///< after step 0
  double step = 0;        ///< seconds; 0: as the scene says
};

/// Steps the scene, puts every pair of bodies that a world looks at to every engine that knows
/// such shapes, and has each difference judged (ShapeJudge). That the world and graze alone differ
/// is wrong of the world, whoever else is right: hierarchies and memory change nothing (law 9).
/// Of steps before the range nothing is asked; the world goes through them all the same, for what
/// it remembers is on trial. Of `on_records` see run_comparison(). Throws what Simulation throws.
void compare_scene(const Scene& scene, std::span<const EngineEntry> engines,
                   const SceneComparisonSettings& settings, const PlaceRange& range,
                   const std::function<bool(std::vector<StepRecord>)>& on_records);

/// The question about two bodies of the scene at a time.
Case case_of(const Scene& scene, const ScenePair& pair, double time);

}  // namespace graze::compare
