#pragma once

#include <graze/bvh/build/reference.h>

namespace graze::bvh {

/// The smallest box around centroids, as Bounds are.
struct Spread {
  Lanes minus_low;
  Lanes high;
};

/// Adds a centroid. NaN adds nothing.
static inline void extend(Spread& spread, Lanes centroid) {
  spread.minus_low = larger(-centroid, spread.minus_low);
  spread.high = larger(centroid, spread.high);
}

static inline Spread empty_spread() {
  const Bounds none = empty_bounds();
  return {none.minus_min, none.max};
}

/// References that will be a subtree, and what a split must know of them.
struct Part {
  std::size_t begin = 0;
  std::size_t end = 0;
  int depth = 0;  // nodes above
  Bounds box = empty_bounds();
  Spread spread = empty_spread();

  std::size_t size() const { return end - begin; }
};

/// Of the references from begin to end, by looking at each.
Part part_of(std::span<const Reference> references, std::size_t begin, std::size_t end, int depth);

}  // namespace graze::bvh
