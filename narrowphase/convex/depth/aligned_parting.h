#pragma once

#include <graze/narrowphase/convex/depth/penetration.h>

#include <optional>

namespace graze::narrowphase {

/// Returns the least penetration of two sets that lie along one set of axes, by formula, and
/// nothing for any others. For such sets a polytope is at its worst, as many directions are as good
/// or nearly so. The depth is proved to `tolerance`, metres, which says how far from aligned they
/// may be.
///
/// With x0, x1, x2 the squares of a unit direction's coordinates along the axes, the supports of a
/// box, a segment, a cylinder and an ellipsoid about its centre are sums of roots of linear
/// functions of x: concave. So is their sum, if what the offset c between the centres takes off is
/// no more along each axis than what boxes, segments and cylinders are long there. A concave
/// function is least in a corner of the triangle of all x: along an axis.
///
/// Of two bodies of revolution the displacement aside is along axis 0, and there a cylinder's
/// radius counts as its length does. The sum need not be concave then, but is least in a corner all
/// the same. Let R be the radii and H the half lengths, those along axis 2 less c2, none negative.
///   About one axis: R sqrt(x0 + x1) - c0 sqrt(x0) + H sqrt(x2) falls with x0 where x2 is fixed. So
/// x1 is 0, and what is left, (R - c0) sqrt(x0) + H sqrt(x2), is concave for c0 <= R.
///   A about axis 2 and B about 0: R_a sqrt(x0 + x1) + R_b sqrt(x1 + x2) + H_a sqrt(x2) +
/// (H_b - c0) sqrt(x0) is concave for c0 <= H_b; beyond, it falls with x0 where x2 is fixed, x1 is
/// 0, and (R_a + H_b - c0) sqrt(x0) is concave for c0 <= R_a + H_b.
///   A about axis 2 and B about 1: f = R_a sqrt(x0 + x1) + R_b sqrt(x0 + x2) - c0 sqrt(x0) +
/// H_b sqrt(x1) + H_a sqrt(x2). For c0 >= R_b it falls with x0 where x2 is fixed, so x1 is 0; then
/// it falls with x0, or is concave for c0 <= R_a. For c0 >= R_a likewise, x2 being 0. For c0 below
/// both, on any line from the corner of x2 to a point y of the side opposite, f is R_a sqrt(y0 +
/// y1) - c0 sqrt(y0) + H_b sqrt(y1), not negative, times a root, and roots: concave, so least at
/// an end; and on that side it is R_a + (R_b - c0) sqrt(x0) + H_b sqrt(x1): concave.
///
/// Cones, cylinders, segments and points about one line are polygons turned about it. So is their
/// difference, whose boundary is nearest to a point inside along the normal of one of its sides,
/// which is one of theirs. With a cone nothing else is known: its support is no such sum. Two balls
/// part along the line between their middles.
std::optional<Penetration> part_aligned(const Core& a, const Core& b, double tolerance);

}  // namespace graze::narrowphase
