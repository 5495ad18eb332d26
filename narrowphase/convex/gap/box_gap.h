#pragma once

#include <graze/narrowphase/convex/gap/core_gap.h>

namespace graze::narrowphase {

/// The gap of two boxes by trying all of their corners, edges and faces, for boxes that core_gap()
/// leaves open and those that are nearer to each other than it can tell. Boxes that are apart are
/// nearest in a corner of one and a point of the other, or in two edges. `upper` is the distance
/// of two such points, right to 128 u of the scale for rotations; `lower` that of two planes, along
/// the way between the points or one of the 15 axes that may part boxes. Of boxes that overlap the
/// points are some on their edges. Some microseconds.
CoreGap box_gap(const Core& a, const Core& b);

}  // namespace graze::narrowphase
