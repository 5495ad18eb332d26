#pragma once

#include <functional>
#include <string>
#include <vector>

#include "samples/simulation/scenes/scene_run.h"

namespace graze::samples {

/// Says what a scene did. The last part is the last quarter of its steps.
struct SceneReport {
  std::string name;
  int steps = 0;
  double drift = 0;  ///< metres, the most that a point of a body was from where the last part began
  double speed = 0;  ///< m/s, the most of any point of a body in the last part
  double energy = 0;  ///< the greatest rise of the energy above its least value so far, as a share
                      ///< of the energy at first
  double excess = 0;  ///< m/s, the most of a centre beyond what falling explains; negative if below
  double depth = 0;   ///< metres: the deepest contact in the last part
  double contacts = 0;        ///< the average number in a step of the last part
  double world_seconds = 0;   ///< seconds of one core
  double solver_seconds = 0;  ///< seconds of one core
};

/// Says what is asked of a scene.
struct SceneLimits {
  double drift = 1e-3;   ///< metres, for a scene that is to rest
  double speed = 1e-3;   ///< m/s, for a scene that is to rest
  double energy = 0.01;  ///< a share of the energy at first
  double excess = 0.1;   ///< m/s: what gravity adds in a step, and what pushing apart may
};

/// Runs a scene to its end; `look` is called after each step.
SceneReport run_scene(const Scene& scene, const std::function<void(const SceneRun&)>& look = {});

/// Returns one line for each limit that was exceeded; none for scenes of which nothing is asked.
std::vector<std::string> complaints(const SceneReport& report, Outcome outcome,
                                    const SceneLimits& limits = {});

}  // namespace graze::samples
