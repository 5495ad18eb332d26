#pragma once

#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/verdict.h>

namespace graze::narrowphase {

/// What can be known of two triangles without arithmetic, exactly: triangles that share a vertex
/// touch, those whose boxes do not are apart. Not finite input is Unsure.
Verdict compare_coordinates(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::narrowphase
