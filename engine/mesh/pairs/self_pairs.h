#pragma once

// This hands out pairs of a mesh with itself as they are found. It is private to the library.

#include <graze/bvh/traverse/traversal.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <functional>

namespace graze {

/// Calls `on_pair(pair)`, a < b, for each pair of triangles that cross, in no order of meaning, and
/// now and then `on_done(count)` with how many triangles have met their nearest neighbours: that
/// grows, as the work does, to the number of all.
void for_each_self_intersection(const Mesh& mesh, Work& work,
                                const std::function<void(TrianglePair)>& on_pair,
                                const std::function<void(std::size_t)>& on_done);

}  // namespace graze
