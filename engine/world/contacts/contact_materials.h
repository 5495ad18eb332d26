#pragma once

// What shapes are made of where they meet. Private to engine/world.

#include <graze/engine/work.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/placed_shape.h>

namespace graze {

/// Gives contacts of the two their materials, if a mesh or a height field among them has any.
void add_materials(const PlacedShapeView& a, const PlacedShapeView& b, Manifold& found, Work& work);

}  // namespace graze
