#pragma once

#include <graze/narrowphase/predicates/verdict.h>
#include <graze/narrowphase/triangle_triangle.h>

// The stages of intersects() for two triangles.

namespace graze::narrowphase {

/// Returns what intersects() answers, with the stage that decided.
Decision decide(const Triangle& triangle_a, const Triangle& triangle_b);

/// Asks the floating-point stage alone, which is sure or unsure (law 6). Input that is not finite
/// is Unsure.
Verdict triage(const Triangle& triangle_a, const Triangle& triangle_b);

/// Asks the exact stage alone. Throws as intersects() does.
bool intersects_exactly(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::narrowphase
