#pragma once

#include <filesystem>

#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/record/journal.h>
#include <graze/engine/compare/run/scene_comparison.h>

namespace graze::compare {

/// Returns the head for two meshes: their content, the poses, the question and its settings.
JournalHead head_of(const ComparisonJob& job);

/// Returns the head for a scene: the file's bytes, its meshes, the length of a step, and the
/// question if it is about ways. Throws SceneError if the file cannot be read.
JournalHead head_of(const std::filesystem::path& file, const Scene& scene,
                    const SceneComparisonSettings& settings);

/// Returns the head for cases: their names and their content.
JournalHead head_of(const CaseJob& job);

}  // namespace graze::compare
