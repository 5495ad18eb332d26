#pragma once

#include <graze/bvh/aabb.h>
#include <span>

namespace graze::bvh {

/// The smallest box around all boxes, exactly. Throws InputError, naming the box, unless there is
/// at least one and each is valid. Parallel.
Aabb checked_bounds(std::span<const Aabb> boxes);

}  // namespace graze::bvh
