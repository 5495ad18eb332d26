#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/value/separating_axes.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

/// Two boxes in the frame of the first, common units, but for rounding.
struct PlacedBoxes {
  double half_a[3];
  double half_b[3];
  double offset[3];  // from the centre of A's box to that of B's

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

/// How far apart two boxes are along the axes of each.
struct FaceGaps {
  const double (&rotation)[3][3];
  PlacedBoxes boxes;

  FaceGaps(const RelativeFrame& frame, const FloatBox& a, const FloatBox& b)
      : rotation(frame.rotation), boxes(frame, a, b) {}

  // The largest of 0 and what is along each axis: never what is no number.

  double along_a() const {
    const double(&half_b)[3] = boxes.half_b;
    double gap = 0;
    for (int i = 0; i < 3; ++i) {
      const double(&row)[3] = rotation[i];
      const double radii = boxes.half_a[i] + std::abs(row[0]) * half_b[0] +
                           std::abs(row[1]) * half_b[1] + std::abs(row[2]) * half_b[2];
      gap = std::max(gap, std::abs(boxes.offset[i]) - radii);
    }
    return gap;
  }

  double along_b() const {
    const double(&half_a)[3] = boxes.half_a;
    const double(&offset)[3] = boxes.offset;
    double gap = 0;
    for (int j = 0; j < 3; ++j) {
      const double column[3] = {rotation[0][j], rotation[1][j], rotation[2][j]};
      const double distance = offset[0] * column[0] + offset[1] * column[1] + offset[2] * column[2];
      const double radii = boxes.half_b[j] + std::abs(column[0]) * half_a[0] +
                           std::abs(column[1]) * half_a[1] + std::abs(column[2]) * half_a[2];
      gap = std::max(gap, std::abs(distance) - radii);
    }
    return gap;
  }
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
