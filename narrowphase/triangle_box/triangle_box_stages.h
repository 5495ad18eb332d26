#pragma once

#include <graze/narrowphase/predicates/verdict.h>
#include <graze/narrowphase/triangle_box.h>

// The stages of intersects() for a triangle and a box.

namespace graze::narrowphase {

/// Returns what intersects() answers, with the stage that decided.
Decision decide(const Triangle& triangle, const Aabb& box);

/// Asks the floating-point stage alone. Input that is not finite is Unsure.
Verdict triage(const Triangle& triangle, const Aabb& box);

/// Asks the exact stage alone. Throws as intersects() does.
bool intersects_exactly(const Triangle& triangle, const Aabb& box);

}  // namespace graze::narrowphase
