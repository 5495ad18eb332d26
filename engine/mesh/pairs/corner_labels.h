#pragma once

// This is private to engine/mesh.

#include <graze/engine/mesh/mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace graze {

/// Returns three numbers for each triangle. Two triangles have one in common only if they surely
/// meet in no more than the welded vertex or edge that they share. It takes linear time, but for
/// vertices that dozens of triangles share.
std::vector<std::array<std::uint32_t, 3>> corner_labels(const Mesh& mesh);

}  // namespace graze
