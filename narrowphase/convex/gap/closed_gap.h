#pragma once

#include <graze/narrowphase/convex/gap/core_gap.h>

namespace graze::narrowphase {

/// Returns what core_gap() answers, by a formula where there is one: for points and segments among
/// themselves, and for a point and a box.
CoreGap nearest(const Core& a, const Core& b, const GapGoal& goal = {});

/// Returns the gap's normal, or where the gap is known by formula and is not 0 a normal whose
/// planes are as far apart as `lower` says, but for rounding. The direction between two points is
/// off by what the points are over their distance, which tells little of points that are near each
/// other.
Vec3 gap_normal(const Core& a, const Core& b, const CoreGap& gap);

/// Returns the point of the box nearest to a point. A point inside stays where it is.
Vec3 nearest_in_box(const Core& box, const Vec3& point);

/// True if nearest() has a formula for these kinds.
bool has_closed_gap(CoreKind a, CoreKind b);

/// Returns the gap of two boxes by trying all of their corners, edges and faces, for boxes that
/// core_gap() leaves open and those that are nearer to each other than it can tell. Boxes that are
/// apart are nearest in a corner of one and a point of the other, or in two edges. `upper` is the
/// distance of two such points, right to 128 u of the scale for rotations, and `lower` is that of
/// two planes, along the line between the points or one of the 15 axes that may part boxes. For
/// boxes that overlap the points are some on their edges. Takes some microseconds.
CoreGap box_gap(const Core& a, const Core& b);

}  // namespace graze::narrowphase
