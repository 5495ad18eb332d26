#pragma once

#include <graze/bvh/build/reference.h>

namespace graze::bvh {

/// The smallest box around centroids, kept as Bounds are.
struct CentroidBounds {
  Lanes minus_low;
  Lanes high;
};

/// Adds a centroid. NaN adds nothing.
static inline void extend(CentroidBounds& bounds, Lanes centroid) {
  bounds.minus_low = larger(-centroid, bounds.minus_low);
  bounds.high = larger(centroid, bounds.high);
}

static inline CentroidBounds empty_centroid_bounds() {
  const Bounds none = empty_bounds();
  return {none.minus_min, none.max};
}

/// References that will be a subtree, and what a split must know of them.
struct Part {
  std::size_t begin = 0;
  std::size_t end = 0;
  int depth = 0;  ///< how many nodes are above the part
  Bounds box = empty_bounds();
  CentroidBounds centroids = empty_centroid_bounds();

  std::size_t size() const { return end - begin; }
};

/// Returns the part of the references from begin to end; it looks at each.
Part part_of(std::span<const Reference> references, std::size_t begin, std::size_t end, int depth);

}  // namespace graze::bvh
