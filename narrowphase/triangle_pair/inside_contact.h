#pragma once

// Decides about contacts with the inside of a triangle, exactly. Private to the library.

#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// True if some point of `other`, which is closed, lies in `triangle` and on none of its edges.
/// Both must be finite and have area.
bool meets_inside(const Triangle& other, const Triangle& triangle);

/// True if triangles of one plane turn the same way, as seen from either side of it. They must have
/// area.
bool turn_alike(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::narrowphase
