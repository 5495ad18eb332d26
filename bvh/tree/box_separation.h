#pragma once

#include <graze/bvh/tree/tree.h>

namespace graze::bvh {

/// Says how the frame of tree B lies in that of tree A, in common units: a point b of B's local
/// frame is at rotation * (b * units_b) + translation, a point a of A's at a * units_a. `slack`, in
/// the same units, covers all by which the query's truth may differ from that, and the rounding of
/// all that compares boxes here: whoever fills this in derives it (law 5).
struct RelativeFrame {
  double rotation[3][3];  ///< row-major
  double translation[3];
  double units_a;
  double units_b;
  double slack;
};

/// Proves pairs of node boxes apart by the separating axis test for oriented boxes: three axes of
/// each and nine cross products (Gottschalk, Lin and Manocha, "OBBTree", 1996). One rotation serves
/// the whole query. An answer of true is sure; false is not.
class BoxSeparation {
 public:
  explicit BoxSeparation(const RelativeFrame& frame);

  bool are_apart(const FloatBox& a, const FloatBox& b) const;

  /// True if the first box is larger, and so the one to open.
  bool is_first_larger(const FloatBox& a, const FloatBox& b) const;

 private:
  RelativeFrame frame_;
  double size_[3][3];  ///< the absolute values of the rotation
};

/// True if an axis of one box or the other has them further apart than the slack. What cross
/// products of edges would prove beside that is little, and takes longer than all of this.
bool are_apart_along_faces(const RelativeFrame& frame, const FloatBox& a, const FloatBox& b);

/// Returns how far apart these axes have them, common units, as it is rounded: the slack covers
/// that. It is 0 where they overlap along all.
double gap_along_faces(const RelativeFrame& frame, const FloatBox& a, const FloatBox& b);

}  // namespace graze::bvh
