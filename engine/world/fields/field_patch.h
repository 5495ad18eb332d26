#pragma once

// Cells of a height field as a mesh. Private to engine/world.

#include <graze/engine/world/fields/field_data.h>

#include <span>
#include <vector>

namespace graze {

/// The triangles of the cells in these rectangles that are no holes, as a mesh that answers as the
/// whole field's does near them (mesh_patch.h). At least one cell must be none.
Mesh patch_of(const HeightFieldData& field, std::span<const CellRect> rects);

/// The same of one rectangle. This thread keeps some hundreds if they are small: a body that stays
/// where it is, or several at one place, ask for the same, which changes no answer.
Mesh kept_patch_of(const HeightFieldData& field, const CellRect& rect);

}  // namespace graze
