#pragma once

// Private to engine/mesh.

#include <graze/engine/mesh/pair.h>

#include <vector>

namespace graze {

/// Ascending. From twenty on they take a fifth of the time of std::sort.
void sort_pairs(std::vector<TrianglePair>& pairs);

}  // namespace graze
