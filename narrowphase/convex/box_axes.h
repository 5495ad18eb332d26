#pragma once

#include <graze/narrowphase/convex/penetration.h>

namespace graze::narrowphase {

/// The least way out of two boxes, by their 15 axes: for poses that are rotations exact but for
/// rounding, and by as much as they deviate for others. A product of edges
/// must save more than a twentieth of the depth over the best face, so that boxes that rest on one
/// another do not change their axis from step to step; where one does, the points are the nearest
/// ones of the two edges that meet.
/// Gottschalk, Lin, Manocha, "OBBTree" (1996).
Penetration least_axis(const Core& box_a, const Core& box_b);

/// The ends of a box's edge along one of its axes: of the four the farthest along a direction.
struct BoxEdge {
  Vec3 from;
  Vec3 to;
};
BoxEdge edge_along(const Core& box, int axis, const Vec3& direction);

/// The least way out of a box and a point with a radius whose middle is inside the box: by the
/// nearest face. The normal leads from the box.
Penetration nearest_face(const Core& box, const Core& point);

}  // namespace graze::narrowphase
