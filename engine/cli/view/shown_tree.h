#pragma once

#include <cstdint>
#include <optional>

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/view/view.h>

namespace graze::cli {

/// Says which volumes of a tree are drawn: those that pages can draw as they are.
enum class TreeBoxes {
  Aabb,  ///< axis-aligned in the mesh's frame
  Obb,   ///< oriented
};

/// Adds the boxes of a mesh's tree to its body, level by level. A level with more than 4,096 boxes
/// is not drawn, nor is any below; the first such level is returned, if there is one.
std::optional<std::uint32_t> add_tree(const Mesh& mesh, TreeBoxes boxes, ViewBody body, View& view);

}  // namespace graze::cli
