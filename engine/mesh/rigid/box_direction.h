#pragma once

// This is private to engine/mesh/rigid.

#include <graze/engine/mesh/rigid/moving_pair.h>
#include <graze/narrowphase/lanes/two_lanes.h>

namespace graze {

/// Looks for an axis along which two boxes are far apart: first among the normals of their faces,
/// which are enough for most, then among the cross products of their edges.
class AxisSearch {
 public:
  /// Takes two boxes, which must outlive this. An axis counts only if it has them further apart
  /// than so many metres, at least 0.
  AxisSearch(const PlacedBodies& placed, const BodyBox& a, const BodyBox& b, double limit);

  /// Finds the best of the normals. Returns false if there is none.
  bool try_faces(ApartDirection& direction);

  /// Finds the best of the cross products. Returns false if none is better than all normals.
  bool try_edges(ApartDirection& direction);

 private:
  using TwoLanes = narrowphase::TwoLanes;

  /// Three values along the axes of B: two, and the third beside a zero.
  struct AlongB {
    TwoLanes at[2];
    double operator[](int j) const { return at[j / 2][j % 2]; }
  };

  template <int I>
  void try_edges_of();
  void take(double distance, double radius, double square, int of_a, int of_b);
  void set_direction(ApartDirection& direction) const;

  const PlacedBodies& placed_;
  const BodyBox& box_a_;
  const BodyBox& box_b_;
  // Both boxes along the axes of the first.
  AlongB rotation_[3];
  AlongB size_[3];
  double offset_[3];
  bool holds_centre_ = true;  ///< whether A holds the centre of B: then no axis has them apart
  // The axis that is best so far.
  double gap_;        ///< the distance of the boxes along it, or the limit
  double along_ = 0;  ///< the distance of the centres along it
  int i_ = -1;        ///< its axis of A, 0 to 2, or -1 for none
  int j_ = -1;        ///< its axis of B
};

}  // namespace graze
