#pragma once

#include <graze/engine/compare/judge/judgement.h>

namespace graze::compare {

/// Of the questions any and pairs about shapes of which B, or both, are volumes. Exact; graze is
/// right to call oriented boxes a hit that are apart by rounding, and is not judged where it does
/// so though they are further apart (law 11: there only "apart" is sure).
Judgement judge_volumes(const Case& query, const CaseAnswer& answer, bool is_graze);

}  // namespace graze::compare
