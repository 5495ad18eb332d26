#pragma once

#include <graze/bvh/aabb.h>
#include <span>

namespace graze::bvh {

/// Returns the smallest box around all boxes, exactly. It is parallel. Throws InputError, naming
/// the box, unless there is at least one and each is valid.
Aabb checked_bounds(std::span<const Aabb> boxes);

}  // namespace graze::bvh
