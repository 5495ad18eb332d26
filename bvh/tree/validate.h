#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/tree/tree.h>
#include <optional>
#include <span>
#include <string>

namespace graze::bvh {

/// Returns in words the first invariant that the tree over these boxes breaks, nothing if it keeps
/// all: every node is reached once and behind its parent, every primitive is in exactly one leaf,
/// and every node's box holds its children and, in exact arithmetic, the boxes of its primitives.
std::optional<std::string> find_broken_invariant(const Tree& tree, std::span<const Aabb> boxes);

}  // namespace graze::bvh
