#pragma once

#include <graze/bvh/build/part.h>
#include <graze/bvh/build/sah_sweep.h>

namespace graze::bvh {

/// The cheapest plane between bins of centroids.
struct BinSplit {
  Cut cut;  ///< its axis is negative when all centroids fall together
  Lanes low;
  Lanes bins_per_unit;
  bool is_sampled;  ///< true if the plane is known, but not what is on its sides
  Bounds boxes[2];  ///< the boxes around those in front, and behind
};

/// Returns the cheapest split of several references, along all three axes. Of very many references
/// only some are looked at.
BinSplit find_bin_split(std::span<const Reference> references, const Part& part,
                        const SweepCosts& costs);

/// Reorders the part, in its place, to both sides of the plane, and returns them. Those in front
/// keep their order.
void partition(std::span<Reference> references, const Part& part, const BinSplit& split,
               Part (&sides)[2]);

}  // namespace graze::bvh
