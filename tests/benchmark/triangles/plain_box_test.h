#pragma once

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/triangle.h>

namespace graze::benchmark {

/// Akenine-Möller's thirteen axes in plain double: rounded, and compared without any bound.
bool plain_box_test(const Triangle& triangle, const Aabb& box);

}  // namespace graze::benchmark
