#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/tree/tree.h>
#include <span>

namespace graze::bvh {

/// Fits the volumes of a tree to new boxes of the same primitives, which may have moved anywhere;
/// the topology stays. It takes linear time. Throws InputError for another number of boxes or an
/// invalid one, and then leaves the tree as it was.
void refit(Tree& tree, std::span<const Aabb> boxes);

}  // namespace graze::bvh
