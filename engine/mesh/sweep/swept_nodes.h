#pragma once

#include <array>

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/sweep/sweep.h>

namespace graze::contacts {

/// Bounds how far pairs of nodes have to be swept. All boxes of a tree have the same axes: one set
/// of directions serves the whole sweep, and the extents of a box along them are found once for all
/// pairs that it comes into.
class SweptNodes {
 public:
  static constexpr std::size_t kDirections = 13;

  /// The interval of a box along each direction, relative to its tree's centre.
  struct Extent {
    std::array<double, kDirections> middle;
    std::array<double, kDirections> half;
  };

  SweptNodes(const PlacedMeshView& a, const PlacedMeshView& b, const SweepUnits& units,
             const double (&direction)[3]);

  Extent extent_a(const bvh::FloatBox& box) const { return extent(box, scale_a_); }
  Extent extent_b(const bvh::FloatBox& box) const { return extent(box, scale_b_); }

  /// Returns no less than the largest translation at which something in box `a` meets something in
  /// box `b`; negative if there is none. Once it is known to be `enough` or less, any such value
  /// may be returned.
  double last_contact(const Extent& a, const Extent& b, double enough) const;

  /// Return sizes by which the larger one of two boxes is chosen, whichever trees they are of.
  double size_a(const bvh::FloatBox& box) const;
  double size_b(const bvh::FloatBox& box) const;

 private:
  /// The factors of the local coordinates of a tree along a vector n.
  using Scale = std::array<double, 3>;

  /// A vector n, in the sense in which n . d is not negative.
  struct Direction {
    double between;  ///< n . (the centre of A - the centre of B)
    double margin;
    double across;  ///< not negative for what is hardly along the motion: then n . (p - q) is 0 to
                    ///< this
    double up;      ///< the factor of n . (p - q) in the bound of the translation from above
    double down;    ///< the factor in the bound from below
  };
  /// A tree's frame, placed, in the units of the sweep.
  struct Frame {
    Frame(const PlacedMeshView& placed, const SweepUnits& units);

    double centre[3];
    double axis[3][3];
    double unit;
  };

  void add(const double (&n)[3], const double (&d)[3], const Frame& a, const Frame& b);
  Extent extent(const bvh::FloatBox& box, const std::array<Scale, kDirections>& scale) const;

  std::size_t count_ = 0;
  std::array<Direction, kDirections> directions_;
  std::array<Scale, kDirections> scale_a_;
  std::array<Scale, kDirections> scale_b_;
  double unit_a_;
  double unit_b_;
};

}  // namespace graze::contacts
