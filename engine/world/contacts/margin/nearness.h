#pragma once

// Pairs with a margin or with sides. Private to engine/world.

#include <graze/engine/work.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/placed_shape.h>

#include <cstdint>

namespace graze {

/// How two placed shapes stand to each other.
enum class Nearness : std::uint8_t {
  Apart,     ///< by more than the margin
  Near,      ///< by no more than that
  Enclosed,  ///< not touching, but one is where the other's sides count
  Touching   ///< not apart
};

/// Metres, as distance() says, or its lower bound where that has not converged: what is not known
/// to be farther counts as near. Of poses that have been checked.
Nearness nearness(const PlacedShapeView& a, const PlacedShapeView& b,
                  const ManifoldSettings& settings, Work& work);

/// The same with the contacts, in the place of what `found` held: none exactly if they are Apart.
Nearness contacts_within(const PlacedShapeView& a, const PlacedShapeView& b,
                         const ManifoldSettings& settings, Work& work, Manifold& found);

/// Whether the settings ask for no more than what touches.
bool are_plain(const ManifoldSettings& settings);

/// Throws InputError for a margin that is negative, infinite or NaN; what() begins with `what`.
void check_margin(double margin, const char* what);

}  // namespace graze
