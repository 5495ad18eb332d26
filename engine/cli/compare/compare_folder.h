#pragma once

#include <graze/engine/cli/compare/compare_run.h>

namespace graze::cli {

/// `graze compare FOLDER`, of cases, each of which says what is asked. Throws UsageError for
/// options of meshes and scenes, CaseError for what is no case.
ExitCode run_compare_folder(const CompareOptions& options,
                            std::span<const compare::EngineEntry> engines, Output& output);

}  // namespace graze::cli
