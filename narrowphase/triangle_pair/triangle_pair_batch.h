#pragma once

#include <graze/narrowphase/lanes/triangle_rows.h>
#include <graze/narrowphase/lanes/verdicts.h>
#include <graze/narrowphase/predicates/verdict.h>
#include <graze/narrowphase/touch.h>
#include <graze/narrowphase/triangle.h>

#include <cstddef>
#include <cstdint>

namespace graze::narrowphase {

// The rounded stages have one error bound for all determinants of a pair. Notation as in
// predicates.cpp: u is the unit roundoff, n the smallest double.
//
// X, Y, Z are the extents of the six vertices together, largest minus smallest coordinate, rounded.
// Every difference of two of them is at most X, Y, Z even after rounding, which is monotonic. A
// determinant ((b - a) x (c - a)) . (d - a) of any four of the six, computed as written or with its
// arguments in another order, is a sum of six monomials, each at most X Y Z, and carries eight
// roundings in each: three differences, two products, the inner difference and two sums. Exact
// differences are at most (1 + 1.01 u) times X, Y, Z; the error is at most 6 * 8.0001 u (1 + 4 u)
// X Y Z, and X Y Z as computed lacks two roundings: 48.01 u X Y Z.
//
// Underflow: six products lose n / 2 each and are multiplied by at most X, three more lose n / 2:
// 3 n X + 1.5 n, with X <= 2^150 below 2^-922. For X Y Z >= 2^-850 the spare 0.99 u X Y Z is above
// 2^-904. It also covers the rounding of the bound.
inline constexpr double kPairBound = 49 * 0x1p-53;
inline constexpr double kSmallestPairVolume = 0x1p-850;
inline constexpr double kLargestPairExtent = 0x1p+150;

/// Holds pairs of triangles, coordinate by coordinate, for the triage of all at once.
class TrianglePairBatch {
 public:
  static constexpr std::size_t kCapacity = 8;

  TrianglePairBatch() {}  // NOLINT(modernize-use-equals-default): that would clear where it is {}

  std::size_t size() const { return size_; }
  bool is_full() const { return size_ == kCapacity; }
  void clear() { size_ = 0; }

  /// Adds a pair to the batch, which must not be full.
  void add(const Triangle& triangle_a, const Triangle& triangle_b);

  Triangle triangle_a(std::size_t index) const;
  Triangle triangle_b(std::size_t index) const;

  /// Returns coordinate `row` (x, y, z of a, b, c) of all triangles A or B.
  const double* row_a(std::size_t row) const { return a_[row]; }
  const double* row_b(std::size_t row) const { return b_[row]; }

 private:
  /// The first add() clears the rows, so that kernels may compute with lanes that hold no pair.
  /// They are not cleared before, because a query of meshes far apart adds none, and takes little
  /// longer than that.
  alignas(64) double a_[9][kCapacity];
  alignas(64) double b_[9][kCapacity];
  std::size_t size_ = 0;
  bool is_cleared_ = false;
};

/// Returns what triage() says of each pair by its determinants, for the whole batch at once. Pairs
/// that it leaves unsure go to decide_unsure(). The verdicts are the same on every SIMD target.
Verdicts triage(const TrianglePairBatch& batch);

/// Returns what can be known of two triangles without arithmetic, exactly: triangles that share a
/// vertex touch, those whose boxes share no point are apart. Input that is not finite is Unsure.
Verdict compare_coordinates(const Triangle& triangle_a, const Triangle& triangle_b);

/// Returns what decide() answers for a pair that the triage of a batch has left unsure. The rounded
/// determinants would be the same once more, so they are not computed again: coordinates are
/// compared, which is exact and may show that the two are apart, or that they share a vertex; else
/// the exact stage decides. Throws as decide() does.
Decision decide_unsure(const Triangle& triangle_a, const Triangle& triangle_b, Touch touch);

/// Returns what intersects_exactly() does, for any finite coordinates. That falls back on this
/// where coordinates do not fit into 60 bits.
bool intersects_in_doubles(const Triangle& triangle_a, const Triangle& triangle_b);

/// Returns bits: bit i is set if pair i is surely apart because one triangle is strictly on one
/// side of the other's plane. This is the first half of triage(), for less time. The bits are the
/// same on every SIMD target.
std::uint32_t find_apart(const TrianglePairBatch& batch);

/// The number of elements that one Verdicts of the functions below stands for.
inline constexpr std::size_t kVerdictsBlock = 8;

/// Tests one triangle against each of many: verdicts[i] becomes those of elements 8 i to 8 i + 7.
void triage(const Triangle& triangle, const TriangleRows& many, Verdicts* verdicts);

/// Tests pairs: element i of one against element i of the other, which is as long.
void triage(const TriangleRows& triangles_a, const TriangleRows& triangles_b, Verdicts* verdicts);

}  // namespace graze::narrowphase
