#pragma once

#include <graze/narrowphase/convex/depth/penetration.h>
#include <graze/narrowphase/predicates/verdict.h>

namespace graze::narrowphase {

/// Compares two boxes along the 15 axes that may part them: the three of each and the nine
/// products. Gottschalk, Lin, Manocha, "OBBTree" (1996).
class BoxAxes {
 public:
  /// Keeps references to both boxes.
  BoxAxes(const Core& box_a, const Core& box_b);

  /// Returns what may_overlap() of ../volumes/obb_overlap.h says of the two, in either order, and
  /// Unsure where its slack might decide.
  Verdict verdict() const;

  /// True if two edges are so nearly parallel, by less than this sine, that rounding may hide a gap
  /// along their product, and no face axis tells that there is none.
  bool may_hide_gap(double sine) const;

  /// Returns the least penetration. It is exact but for rounding if the poses are rotations, and
  /// else off by as much as they deviate from these. A product of edges must save more than a
  /// twentieth of the depth over the best face, so that boxes that rest on one another do not
  /// change their axis from step to step; where one does, the points are the nearest ones of the
  /// two edges that meet.
  Penetration least_penetration() const;

  /// Returns what lengths are measured by: pair_scale() of the two.
  double scale() const { return pair_scale(box_a_, box_b_); }

 private:
  const Core& box_a_;
  const Core& box_b_;
  // The offset between the middles along the axes, and how far the boxes overlap along them.
  double offset_a_[3], offset_b_[3];
  double overlap_a_[3], overlap_b_[3];
  // The offsets and overlaps along the cross products of an axis of A and one of B, whose squared
  // lengths are in `square_`.
  double offset_[3][3], overlap_[3][3], square_[3][3];
  double margin_;  ///< the bound beyond which an answer is sure
};

/// Holds the ends of a box's edge along one of its axes: of the four such edges the farthest along
/// a direction.
struct BoxEdge {
  Vec3 from;
  Vec3 to;
};
BoxEdge edge_along(const Core& box, int axis, const Vec3& direction);

/// Returns the least penetration of a box and a point with a radius whose middle is inside the box:
/// through the nearest face. The normal leads from the box.
Penetration nearest_face(const Core& box, const Core& point);

}  // namespace graze::narrowphase
