#pragma once

#include <graze/bvh/wide/tree/range_moments.h>

namespace graze::bvh {

/// The axes of a node as rows: three unit vectors at right angles, but for rounding to float.
struct NodeAxes {
  float rows[3][3];
};

inline constexpr NodeAxes kCoordinateAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// Returns axes along which boxes around such primitives are thin: the mean normal of a patch of
/// surface and the principal directions across it; where normals cancel, the principal directions
/// of the corners in space (Gottschalk, Lin and Manocha, "OBBTree", 1996). `corners` is how many
/// corners were summed.
NodeAxes axes_of(const RangeMoments& moments, std::size_t corners);

}  // namespace graze::bvh
