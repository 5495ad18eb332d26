#pragma once

// Answers pairs with a margin or with sides. Private to engine/world.

#include <graze/engine/work.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/placed_shape.h>

#include <cstdint>

namespace graze {

/// The relations of two placed shapes.
enum class Nearness : std::uint8_t {
  Apart,     ///< apart by more than the margin
  Near,      ///< apart by no more than the margin
  Enclosed,  ///< apart, but one is where the other's sides count
  Touching   ///< touching
};

/// Returns the relation of two shapes by distance(), or by its lower bound where that has not
/// converged: shapes that are not known to be farther count as near. The poses must have been
/// checked.
Nearness nearness(const PlacedShapeView& a, const PlacedShapeView& b,
                  const ManifoldSettings& settings, Work& work);

/// Returns the relation of two shapes, and replaces what `found` held by their contacts: none
/// exactly if they are Apart.
Nearness contacts_within(const PlacedShapeView& a, const PlacedShapeView& b,
                         const ManifoldSettings& settings, Work& work, Manifold& found);

/// True if the settings have neither margin nor sides.
bool are_plain(const ManifoldSettings& settings);

/// Throws InputError for a margin that is negative, infinite or NaN; what() begins with `what`.
void check_margin(double margin, const char* what);

}  // namespace graze
