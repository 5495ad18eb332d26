#pragma once

// This is private to engine/mesh.

#include <graze/engine/mesh/query/wide_query.h>
#include <vector>

namespace graze {

/// Returns all pairs of triangles that meet, sorted. So many threads share the query; 0 means all
/// that there are.
std::vector<TrianglePair> find_pairs_in_parallel(const WideQuery& query, Touch touch, int threads,
                                                 Work& work);

}  // namespace graze
