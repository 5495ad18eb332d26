#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/value/separating_axes.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

/// Two boxes in the frame of the first, in common units, but for rounding.
struct PlacedBoxes {
  double half_a[3];
  double half_b[3];
  double offset[3];  ///< the offset of the centre of B's box from that of A's

  PlacedBoxes(const RelativeFrame& frame, const FloatBox& a, const FloatBox& b) {
    const double(&r)[3][3] = frame.rotation;
    const double scale_a = 0.5 * frame.units_a;
    const double scale_b = 0.5 * frame.units_b;
    double centre_b[3];
    for (int k = 0; k < 3; ++k) {
      half_a[k] = (double{a.max[k]} - a.min[k]) * scale_a;
      half_b[k] = (double{b.max[k]} - b.min[k]) * scale_b;
      centre_b[k] = (double{b.max[k]} + b.min[k]) * scale_b;
    }
    for (int i = 0; i < 3; ++i) {
      const double centre_a = (double{a.max[i]} + a.min[i]) * scale_a;
      offset[i] = frame.translation[i] - centre_a + r[i][0] * centre_b[0] + r[i][1] * centre_b[1] +
                  r[i][2] * centre_b[2];
    }
  }
};

/// Says how far apart two boxes are along the axes of each.
class FaceGaps {
 public:
  FaceGaps(const RelativeFrame& frame, const FloatBox& a, const FloatBox& b)
      : rotation_(frame.rotation), boxes_(frame, a, b) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        size_[i][j] = std::abs(rotation_[i][j]);
    }
  }

  // The gaps are the largest of 0 and what is along each axis: never what is no number.

  double along_a() const {
    double gap = 0;
    for (int i = 0; i < 3; ++i)
      gap = std::max(gap, gap_of(along_axis_of_a(in_frame(), i)));
    return gap;
  }

  double along_b() const {
    double gap = 0;
    for (int j = 0; j < 3; ++j)
      gap = std::max(gap, gap_of(along_axis_of_b(in_frame(), j)));
    return gap;
  }

 private:
  BoxesInFrame in_frame() const {
    return {rotation_, size_, boxes_.offset, boxes_.half_a, boxes_.half_b};
  }
  static double gap_of(const AxisProjection& projection) {
    return std::abs(projection.distance) - projection.radius;
  }

  const double (&rotation_)[3][3];
  double size_[3][3];  ///< the absolute values of the rotation
  PlacedBoxes boxes_;
};

}  // namespace

BoxSeparation::BoxSeparation(const RelativeFrame& frame) : frame_(frame) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      size_[i][j] = std::abs(frame.rotation[i][j]);
  }
}

bool BoxSeparation::are_apart(const FloatBox& a, const FloatBox& b) const {
  const PlacedBoxes boxes(frame_, a, b);
  return are_boxes_apart({frame_.rotation, size_, boxes.offset, boxes.half_a, boxes.half_b},
                         frame_.slack);
}

bool BoxSeparation::is_first_larger(const FloatBox& a, const FloatBox& b) const {
  double size_a = 0;
  double size_b = 0;
  for (int k = 0; k < 3; ++k) {
    size_a += double{a.max[k]} - a.min[k];
    size_b += double{b.max[k]} - b.min[k];
  }
  return size_a * frame_.units_a >= size_b * frame_.units_b;
}

bool are_apart_along_faces(const RelativeFrame& frame, const FloatBox& a, const FloatBox& b) {
  const FaceGaps gaps(frame, a, b);
  return gaps.along_a() > frame.slack || gaps.along_b() > frame.slack;
}

double gap_along_faces(const RelativeFrame& frame, const FloatBox& a, const FloatBox& b) {
  const FaceGaps gaps(frame, a, b);
  return std::max(gaps.along_a(), gaps.along_b());
}

}  // namespace graze::bvh
