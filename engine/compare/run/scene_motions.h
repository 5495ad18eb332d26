#pragma once

#include <functional>
#include <span>
#include <vector>

#include <graze/engine/compare/run/scene_comparison.h>

namespace graze::compare {

/// Does what compare_scene() does for questions about motions.
void compare_scene_motions(const Scene& scene, std::span<const EngineEntry> engines,
                           const SceneComparisonSettings& settings, const PlaceRange& range,
                           const std::function<bool(std::vector<StepRecord>)>& on_records);

}  // namespace graze::compare
