#pragma once

// Private to engine/mesh.

#include <graze/engine/mesh/query/wide_query.h>
#include <vector>

namespace graze {

/// All pairs of triangles that meet, sorted, by so many threads (0: all that there are).
std::vector<TrianglePair> find_pairs_in_parallel(const WideQuery& query, Touch touch, int threads,
                                                 Work& work);

}  // namespace graze
