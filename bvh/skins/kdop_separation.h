#pragma once

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/box_separation.h>
#include <cstdint>
#include <span>

namespace graze::bvh {

/// A direction as a nonnegative combination of three of the 18 normals of a k-DOP: the corners of
/// the face of their convex hull that it pierces. What bounds the polytope along the normals then
/// bounds it along the direction.
struct KDopCombination {
  int slab[3];
  /// The weight of the slab's normal, times its sign; one of the two is zero.
  double along[3];    ///< at least 0
  double against[3];  ///< at most 0
};

/// Returns the combination for the direction (x, y, z), off by at most a few roundings.
KDopCombination combination_of(const double (&direction)[3]);

/// Proves pairs of nodes apart by their k-DOPs, of which only those of one mesh can lie along the
/// axes of the common frame: the other's are bounded along all directions of the one by
/// multiply-adds, with combinations made once for the query, and the other way round. An answer of
/// true is sure; false is not.
class KDopSeparation {
 public:
  KDopSeparation(const RelativeFrame& frame, std::span<const FloatKDop> skin_a,
                 std::span<const FloatKDop> skin_b);

  bool are_apart(std::uint32_t a, std::uint32_t b) const;
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const;

  static constexpr int kSlabs = KDop<18>::kSlabs;

 private:
  /// The numbers by which the extents of `other` along the directions of one mesh follow from its
  /// own slabs.
  struct View {
    KDopCombination combinations[kSlabs];
    double shift[kSlabs];  ///< how far the other's origin is along the direction
    double units_own;
    double units_other;
  };

  bool is_apart_in(const View& view, const FloatKDop& own, const FloatKDop& other) const;

  View view_a_;  ///< the view along the directions of A
  View view_b_;
  double slack_;
  std::span<const FloatKDop> skin_a_;
  std::span<const FloatKDop> skin_b_;
};

}  // namespace graze::bvh
