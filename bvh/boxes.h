#pragma once

#include <graze/bvh/aabb.h>
#include <span>

namespace graze::bvh {

/// Throws InputError, naming the box, unless there is at least one and each is valid.
void check_boxes(std::span<const Aabb> boxes);

/// The smallest box around at least one box, exactly.
Aabb bounds_of(std::span<const Aabb> boxes);

}  // namespace graze::bvh
