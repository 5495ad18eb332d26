#pragma once

#include <array>

#include <graze/bvh/tree.h>
#include <graze/engine/mesh/contacts/sweep.h>

namespace graze::contacts {

/// Bounds how far pairs of nodes have to be swept. All boxes of a tree have the same axes: one set
/// of directions serves the whole sweep.
class SweptNodes {
 public:
  SweptNodes(const PlacedMesh& a, const PlacedMesh& b, const SweepUnits& units,
             const double (&direction)[3]);

  /// No less than the largest translation at which something in box `a` meets something in box `b`;
  /// negative if there is none. Once it is known to be `enough` or less, any value that is.
  double last_contact(const bvh::FloatBox& a, const bvh::FloatBox& b, double enough) const;

  /// Which box is larger, to choose the one to open.
  bool is_first_larger(const bvh::FloatBox& a, const bvh::FloatBox& b) const;

 private:
  /// A vector n: what it makes of the coordinates of both trees.
  struct Direction {
    double along;
    double size;
    double between;     // n . (the centre of A - the centre of B)
    double scale_a[3];  // of A's local coordinates
    double scale_b[3];
  };
  /// A tree's frame, placed, in the units of the sweep.
  struct Frame {
    Frame(const PlacedMesh& placed, const SweepUnits& units);

    double centre[3];
    double axis[3][3];
    double unit;
  };

  static Direction direction_of(const double* n, const double* d, const Frame& a, const Frame& b);

  std::array<Direction, 13> directions_;
  double unit_a_;
  double unit_b_;
};

}  // namespace graze::contacts
