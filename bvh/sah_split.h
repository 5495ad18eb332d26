#pragma once

#include <graze/bvh/float_box.h>
#include <cstddef>
#include <cstdint>
#include <span>

namespace graze::bvh {

/// A primitive on its way into a tree.
struct Reference {
  FloatBox box;
  std::uint32_t index;

  /// Twice the centre of the box along an axis: order is all that matters.
  float centroid(int axis) const { return box.min[axis] + box.max[axis]; }
};

/// A plane between two bins of centroids. `cost` is the sum over both sides of primitives times
/// half the surface of their box. axis is negative when all centroids fall together.
struct Split {
  int axis = -1;
  int bin = 0;  // the first bin of the second side
  float low = 0;
  float bins_per_unit = 0;
  float cost = 0;
};

FloatBox bounds_of(std::span<const Reference> references);

/// The cheapest split among those between bins along all three axes. `box` holds all references.
Split find_sah_split(std::span<const Reference> references, const FloatBox& box);

/// Reorders the references to both sides of the split; returns the size of the first side, which is
/// neither empty nor everything.
std::size_t partition_at(std::span<Reference> references, const Split& split);

/// Reorders them to two halves of equal count along the axis on which their centroids spread
/// widest.
std::size_t partition_in_halves(std::span<Reference> references);

}  // namespace graze::bvh
