#pragma once

#include <optional>
#include <string>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>

namespace graze::cli {

/// Holds what proves the truth of a case and how far off the answer in it is: whole sentences, one
/// after the other.
using Reasons = std::vector<std::string>;

/// Returns reasons for a case of two bodies that rest, two in motion, a ray, a point inside or a
/// translation that parts two meshes. The case must have an answer; `judgement` is what the judge
/// says of it. Returns nothing for questions that are gone through elsewhere, or not at all.
std::optional<Reasons> reasons_of(const Case& query, const compare::Judgement& judgement);

// Each of these returns the reasons for one kind of case.
Reasons body_reasons(const Case& query, const compare::Judgement& judgement);
Reasons motion_reasons(const Case& query, const compare::Judgement& judgement);
Reasons ray_reasons(const Case& query, const compare::Judgement& judgement);
Reasons inside_reasons(const Case& query);
Reasons separation_reasons(const Case& query, const compare::Judgement& judgement);  ///< of meshes

/// Says of two meshes or bodies where they stand, with no word of an answer: the triangles that
/// meet, or the plane and the points that tell them apart.
Reasons place_reasons(const Case& query);

/// Returns "(0.5, 0, -1.25)", with the digits that people compare.
std::string words_of(const Eigen::Vector3d& point);

/// Says by how much the answer is off, where it is wrong by a length.
std::string words_of_error(const compare::Judgement& judgement);

}  // namespace graze::cli
