#pragma once

#include <graze/bvh/reference.h>
#include <graze/bvh/tree.h>

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

/// The node, made in registers.
static inline Node node_over(const Bounds& box, std::uint32_t first, std::uint32_t count) {
  struct TwoLanes {
    Lanes low, high;
  };
  const Lanes min = -box.minus_min;
  const Lanes across = __builtin_shufflevector(min, box.max, 2, 2, 4, 4);
  const IntLanes rest = {static_cast<std::int32_t>(first), static_cast<std::int32_t>(count), 0, 0};
  return std::bit_cast<Node>(
      TwoLanes{__builtin_shufflevector(min, across, 0, 1, 4, 6),
               __builtin_shufflevector(box.max, std::bit_cast<Lanes>(rest), 1, 2, 4, 5)});
}

}  // namespace graze::bvh
