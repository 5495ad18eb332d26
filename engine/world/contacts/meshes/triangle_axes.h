#pragma once

// Two triangles by the axes that can separate them, where rounding and the solvers' slack have no
// say. Private to engine/world.

#include <graze/narrowphase/convex/core/vector.h>

namespace graze {

enum class SureVerdict { Apart, Meet, Unsure };

/// Unsure where an axis shows less of a gap, or of an overlap, than rounding and the slack of
/// searches for distances could be.
SureVerdict decide_by_axes(const narrowphase::Vec3 (&a)[3], const narrowphase::Vec3 (&b)[3]);

}  // namespace graze
