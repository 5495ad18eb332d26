#pragma once

// Makes meshes of cells of a height field. Private to engine/world.

#include <graze/engine/world/fields/field_data.h>

#include <span>
#include <vector>

namespace graze {

/// Returns the triangles of the cells in these rectangles that are no holes, as a mesh that answers
/// as the whole field's does near them (mesh_patch.h). At least one cell must be no hole.
Mesh patch_of(const HeightFieldData& field, std::span<const CellRect> rects);

/// Returns the patch of one rectangle. This thread keeps some hundreds of them if they are small,
/// as a body that stays where it is, or several bodies at one place, ask for the same one. This
/// changes no answer.
Mesh kept_patch_of(const HeightFieldData& field, const CellRect& rect);

}  // namespace graze
