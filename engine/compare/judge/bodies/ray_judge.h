#pragma once

#include <graze/engine/compare/judge/judgement.h>

namespace graze::compare {

/// A ray at a mesh or a triangle, the first hit or all of them, in rational numbers: which
/// triangles are met, how far away, in which point and with which normal. The bounds are those that
/// cast_ray() promises, for other engines kTouchUlps. A hit as far as the ray reaches, but for
/// these, may be told either way.
Judgement judge_surface_ray(const Case& query, const CaseAnswer& answer, bool is_graze);

}  // namespace graze::compare
