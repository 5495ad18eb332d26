#pragma once

#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/verdict.h>

namespace graze {

/// True if and only if the two closed triangles share a point, in real arithmetic (law 2). Touching
/// counts; degenerate triangles are what they are; every finite double is answered exactly.
/// Throws InputError for a coordinate that is not finite.
/// Guigue and Devillers, "Fast and robust triangle-triangle overlap test using orientation
/// predicates", Journal of Graphics Tools 8(1), 2003.
bool intersects(const Triangle& triangle_a, const Triangle& triangle_b);

namespace narrowphase {

/// Returns what intersects() answers, with the stage that decided.
Decision decide(const Triangle& triangle_a, const Triangle& triangle_b);

/// Asks the floating-point stage alone, which is sure or unsure (law 6). Input that is not finite
/// is Unsure.
Verdict triage(const Triangle& triangle_a, const Triangle& triangle_b);

/// Asks the exact stage alone. Throws as intersects() does.
bool intersects_exactly(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace narrowphase
}  // namespace graze
