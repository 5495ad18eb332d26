#pragma once

// Tests two triangles by the axes that can separate them, where neither rounding nor the solvers'
// slack matters. Private to engine/world.

#include <graze/narrowphase/convex/core/vector.h>

namespace graze {

enum class SureVerdict { Apart, Meet, Unsure };

/// Decides whether two triangles meet. Unsure if an axis shows a gap, or an overlap, that is
/// smaller than rounding and the slack of searches for distances could be.
SureVerdict decide_by_axes(const narrowphase::Vec3 (&a)[3], const narrowphase::Vec3 (&b)[3]);

}  // namespace graze
