#pragma once

#include <graze/bvh/kdop.h>

namespace graze {

/// False only if the k-DOPs share no point: some slab keeps them apart, by a comparison of doubles.
/// True is not sure, for polytopes can be apart along other directions, and a slab may be looser
/// than its polytope. Throws InputError for a k-DOP that is not finite or has min > max.
/// Klosowski and others, "Efficient collision detection using bounding volume hierarchies of
/// k-DOPs", 1998; "Real-Time Rendering", 3rd ed., 16.13.4.
bool intersects(const KDop<18>& kdop_a, const KDop<18>& kdop_b);

}  // namespace graze
