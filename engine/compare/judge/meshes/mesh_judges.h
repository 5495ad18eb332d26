#pragma once

#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// Judges a translation of B: whether it is as long as is said, along the direction that was asked
/// for, and separates. Whether it separates is not judged if it leaves the range of double. It is
/// right if, in addition, the two still hit a millionth of the length before: then it is no longer
/// than it must be along its direction. Else its length is not judged.
Judgement judge_separation(const Case& query, const MeshCase& meshes, const CaseAnswer& answer);

/// Judges whether a closed mesh or a volume contains a point: exactly, by law 3 for an oriented
/// box. Nothing is judged about a mesh that is not closed.
Judgement judge_contains(const Case& query, bool says);

/// Returns whether two closed placed meshes whose surfaces share no point hold a part of each
/// other; nothing if one of them is not closed.
std::optional<bool> is_one_inside(const MeshCase& meshes);

/// Returns whether a closed placed mesh whose surface shares no point with the volume encloses it;
/// nothing if it is not closed.
std::optional<bool> is_volume_inside(const CaseMesh& mesh, const CaseShape& volume);

}  // namespace graze::compare
