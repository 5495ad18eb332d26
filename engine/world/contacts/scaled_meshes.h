#pragma once

// Contacts of meshes whose sizes are near the ends of the range of double. Private to engine/world.

#include <graze/engine/world/contacts/contact_functions.h>

namespace graze {

/// The contact candidates of two meshes that are so large or so small that products of five lengths
/// may overflow or underflow: those of the same meshes scaled by a power of two, scaled back.
/// Scaling changes no bit of a placed coordinate (law 1) but of one that is denormal. Returns
/// false, and does nothing, for all others.
bool candidates_of_scaled_meshes(const PlacedShapeView& a, const PlacedShapeView& b,
                                 ContactCandidates& candidates, Work& work);

}  // namespace graze
