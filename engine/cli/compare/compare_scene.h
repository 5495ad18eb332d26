#pragma once

#include <graze/engine/cli/compare/compare_run.h>

namespace graze::cli {

/// `graze compare SCENE`. Throws UsageError for options of meshes, SceneError for what is no scene,
/// PoseError for paths that lead beyond what a world can hold.
ExitCode run_compare_scene(const CompareOptions& options,
                           std::span<const compare::EngineEntry> engines, Output& output);

}  // namespace graze::cli
