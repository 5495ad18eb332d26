#pragma once

// Private to engine/mesh.

#include <graze/engine/mesh/pair.h>

#include <vector>

namespace graze {

/// Ascending.
void sort_pairs(std::vector<TrianglePair>& pairs);

}  // namespace graze
