#pragma once

#include <graze/narrowphase/convex/depth/penetration.h>

namespace graze::narrowphase {

/// True if a core's reach bends. Then a direction is known only to the root of what the depth along
/// it is known to.
bool has_bends(const Core& core);

/// Turns the normal of a penetration to where the depth is locally the least, by Newton's method. A
/// depth that is known to a millionth leaves its normal off by a thousandth, and a contact's depth
/// by that share of how far it is beside the deepest point. It looks for the least where a rim, a
/// line on a round side or an ellipsoid meets another of these or an edge; where it finds that, it
/// also finds the points in which the two meet. Else the penetration stays as it is. One of the two
/// has_bends().
void turn_to_nearby_least(const Core& a, const Core& b, Penetration& penetration);

}  // namespace graze::narrowphase
