#pragma once

// A tree over a rectangle of cells. Private to engine/world.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/world/fields/field_data.h>

namespace graze {

/// Over the patch of the rectangle, by halving its longer side: in a fraction of the time that the
/// surface area heuristic takes to find out the same.
bvh::Tree tree_over(const HeightFieldData& field, const CellRect& rect, const MeshPatch& patch);

}  // namespace graze
