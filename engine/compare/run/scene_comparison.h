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
  std::size_t steps = 0;  ///< the number of steps after step 0
  double step = 0;        ///< seconds; 0 for the scene's own step
  /// The question: Any asks whether they touch at each step, FirstContact and Free ask about the
  /// motion from the step before.
  Ask ask = Ask::Any;
  double clearance = 0;  ///< metres, for questions about motions
};

/// Holds a span of a scene's time, seconds.
struct TimeSpan {
  double from = 0;
  double to = 0;
};

/// Steps the scene, puts every pair of bodies that a world looks at to every engine that knows such
/// shapes, and has each difference judged (ShapeJudge). If the world and graze alone differ the
/// world is wrong, whoever else is right: hierarchies and memory change nothing (law 9). Nothing is
/// asked about steps before the range; the world goes through them all the same, for what it
/// remembers is on trial. For `on_records` see run_comparison(). Throws what Simulation throws.
///
/// In questions about motions place n is the motion from step n - 1 to step n, and place 0 has
/// none: each body goes as RigidMotion::between() its two poses does. All pairs of which one moves
/// are asked about. A pair is judged (Judge) if somebody does not call it free, or if it is of two
/// meshes; these pairs are differences, but for meshes whose freedom is proved. In the world
/// everything that the scene moves is swept, and what it lists first of a pair must be what graze
/// says of that pair alone, bit for bit.
void compare_scene(const Scene& scene, std::span<const EngineEntry> engines,
                   const SceneComparisonSettings& settings, const PlaceRange& range,
                   const std::function<bool(std::vector<StepRecord>)>& on_records);

/// Return the question about two bodies of the scene at the end of a time, or in their motions
/// through it.
Case case_of(const Scene& scene, const ScenePair& pair, const SceneComparisonSettings& settings,
             const TimeSpan& span);

}  // namespace graze::compare
