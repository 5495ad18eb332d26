#pragma once

// Tests the overlap of k-DOPs slab by slab, a SIMD width at a time; boxes are k-DOPs of three
// slabs. Callers hand over plain arrays: the minima of all slabs, then the maxima. Rows are padded
// to whole blocks of eight (volume_rows.h); hits are not.

#include <graze/bvh/kdop.h>
#include <graze/narrowphase/volumes/volume_rows.h>
#include <array>
#include <cstddef>
#include <cstdint>

namespace graze::narrowphase {

/// hits[i] becomes 1 if all slabs of `one` and element i of `many` overlap, otherwise 0.
void find_overlaps(const std::array<double, 6>& one, const RowPointers<6>& many, std::size_t count,
                   std::uint8_t* hits);
void find_overlaps(const std::array<double, 18>& one, const RowPointers<18>& many,
                   std::size_t count, std::uint8_t* hits);

/// Does the same for elements i of both.
void find_overlaps(const RowPointers<6>& a, const RowPointers<6>& b, std::size_t count,
                   std::uint8_t* hits);
void find_overlaps(const RowPointers<18>& a, const RowPointers<18>& b, std::size_t count,
                   std::uint8_t* hits);

enum class KDopPairAnswer {
  Apart,
  MayOverlap,
  Invalid,  ///< a slab of either is not finite, or its minimum exceeds its maximum
};

/// Checks two k-DOPs and tells them apart at once, by comparisons of whole numbers: right however
/// the thread computes.
KDopPairAnswer look_at_pair(const KDop<18>& a, const KDop<18>& b);

}  // namespace graze::narrowphase
