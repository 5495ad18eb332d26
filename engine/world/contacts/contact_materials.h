#pragma once

// Finds the materials of shapes where they meet. Private to engine/world.

#include <graze/engine/work.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/placed_shape.h>

namespace graze {

/// Sets the materials in the contacts of two shapes, if either is a mesh or a height field that has
/// any.
void add_materials(const PlacedShapeView& a, const PlacedShapeView& b, Manifold& found, Work& work);

}  // namespace graze
