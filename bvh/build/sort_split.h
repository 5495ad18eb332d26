#pragma once

#include <graze/bvh/build/part.h>
#include <graze/bvh/build/sah_sweep.h>

namespace graze::bvh {

/// At most this many references are sorted to be split: that is cheaper than bins would be, and no
/// plane between two centroids is missed.
constexpr std::size_t kMostSorted = 8;

/// References in the order of their centroids along each axis.
struct SortSplit {
  Cut cut;  ///< a cut of the order along its axis; it is always found
  std::uint8_t order[kMostSorted][4];
};

/// Returns the cheapest cut of the orders along all three axes, of 2 to kMostSorted references.
SortSplit find_sort_split(std::span<const Reference> references, const SweepCosts& costs);

/// Brings the part into the order of the split and returns both sides of the cut.
void partition(std::span<Reference> references, const Part& part, const SortSplit& split,
               Part (&sides)[2]);

}  // namespace graze::bvh
