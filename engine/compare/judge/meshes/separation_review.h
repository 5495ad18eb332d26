#pragma once

#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// A translation of B: whether it is as long as is said, along the direction that was asked for,
/// and separates. Nothing is said of that if it leaves the range of double. Right if, in addition,
/// the two still hit a millionth of the length before: then it is no longer than it must be along
/// its direction. Else its length is not judged.
Judgement judge_separation(const Case& query, const MeshCase& meshes, const CaseAnswer& answer);

}  // namespace graze::compare
