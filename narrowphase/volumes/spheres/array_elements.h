#pragma once

#include <graze/narrowphase/volumes/sphere_arrays.h>

// What batches of spheres and boxes ask of their arrays.

namespace graze::narrowphase {

/// Throw InputError, which begins with `what`, unless all arrays have one length.
void check_lengths(const SphereArray& spheres, const char* what);
void check_lengths(const AabbArray& boxes, const char* what);

/// Returns element `index` as it is, unchecked.
Sphere element(const SphereArray& spheres, std::size_t index);
Aabb element(const AabbArray& boxes, std::size_t index);

}  // namespace graze::narrowphase
