#pragma once

#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/predicates/verdict.h>

// The stages of crosses(), and of intersects() under a policy.

namespace graze::narrowphase {

/// Returns what intersects() answers under this policy, with the stage that decided.
Decision decide(const Triangle& triangle_a, const Triangle& triangle_b, Touch touch);

/// Asks the floating-point stage of crosses() alone: Yes means that they cross. Input that is not
/// finite is Unsure.
Verdict crossing_triage(const Triangle& triangle_a, const Triangle& triangle_b);

/// Asks the exact stage of crosses() alone. Throws as crosses() does.
bool crosses_exactly(const Triangle& triangle_a, const Triangle& triangle_b);

/// Throws InputError for a value that is no policy.
void check_touch(Touch touch);

}  // namespace graze::narrowphase
