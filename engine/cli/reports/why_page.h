#pragma once

#include <string>

#include <graze/engine/cli/reports/case_explanation.h>
#include <graze/engine/cli/reports/explanation.h>

namespace graze::cli {

// These functions return pages of the viewer that show what `graze explain` says. They throw
// UsageError where the command was built without pages, and what the queries for the pictures
// throw.

/// Shows two meshes, and then the triangles alone that decide, with the plane or the point that
/// proves it.
std::string why_page(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                     const std::string& name_a, const std::string& name_b,
                     const Explanation& explanation);

/// Shows a case, with what is said of its answer.
std::string why_page(const Case& query, const std::string& name,
                     const CaseExplanation& explanation);

}  // namespace graze::cli
