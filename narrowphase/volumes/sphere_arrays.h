#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/sphere.h>
#include <array>
#include <cstddef>
#include <span>

namespace graze {

/// Holds spheres coordinate by coordinate, metres: element i of each array, all of one length. A
/// view: the caller keeps the memory.
struct SphereArray {
  std::span<const double> x;       ///< the centres' x
  std::span<const double> y;       ///< the centres' y
  std::span<const double> z;       ///< the centres' z
  std::span<const double> radius;  ///< the radii, not negative

  std::size_t size() const { return x.size(); }
};

/// Holds axis-aligned boxes in the same way; arrays 0, 1, 2 are x, y, z.
struct AabbArray {
  std::array<std::span<const double>, 3> min;  ///< the least x, y and z
  std::array<std::span<const double>, 3> max;  ///< the greatest x, y and z

  std::size_t size() const { return min[0].size(); }
};

}  // namespace graze
