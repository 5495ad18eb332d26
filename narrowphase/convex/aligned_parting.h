#pragma once

#include <graze/narrowphase/convex/penetration.h>

#include <optional>

namespace graze::narrowphase {

/// The least way out of two sets that lie along one set of axes, by formula: nothing for any
/// others. There a polytope is at its worst, as many directions are as good or nearly so. Proved to
/// `tolerance`, metres, which says how far from aligned they may be.
///
/// With x the squares of a unit direction's coordinates along the axes, the supports of a box, a
/// segment, a cylinder and an ellipsoid about its centre are sums of roots of linear functions of
/// x: concave. So is their sum, if what the way between the centres takes off is no more along each
/// axis than what boxes, segments and cylinders there are long. A concave function is least in a
/// corner of the triangle of all x: along an axis. Around cylinders one axis is chosen towards the
/// other's.
///
/// Cones, cylinders, segments and points about one line are polygons turned about it. So is their
/// difference, whose boundary is nearest to a point inside along the normal of one of its sides,
/// which is one of theirs. Two balls part along the way between their middles.
std::optional<Penetration> part_aligned(const Core& a, const Core& b, double tolerance);

}  // namespace graze::narrowphase
