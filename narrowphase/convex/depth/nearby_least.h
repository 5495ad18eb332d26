#pragma once

#include <graze/narrowphase/convex/depth/penetration.h>

namespace graze::narrowphase {

/// Whether a core's reach bends: then what a polytope knows of a direction is the root of what it
/// knows of the depth along it.
bool has_bends(const Core& core);

/// Turns the normal of a penetration to where the depth is locally the least, by Newton's method. A
/// depth that is known to a millionth leaves its normal off by a thousandth, and a contact's depth
/// by that share of how far it is beside the deepest point. What is looked for is the least where a
/// rim, a line on a round side or an ellipsoid meets another or an edge; where it is found so are
/// the points in which the two meet. Else the penetration stays as it is. One of the two
/// has_bends().
void turn_to_nearby_least(const Core& a, const Core& b, Penetration& penetration);

}  // namespace graze::narrowphase
