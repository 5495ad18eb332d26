#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Throws InputError, naming `what` and the vertex, for a coordinate that is not finite.
void check_finite(const Triangle& triangle, const char* what);

}  // namespace graze::narrowphase
