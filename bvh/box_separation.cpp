#include <graze/bvh/box_separation.h>
#include <graze/bvh/separating_axes.h>

#include <cmath>

namespace graze::bvh {

BoxSeparation::BoxSeparation(const RelativeFrame& frame) : frame_(frame) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      size_[i][j] = std::abs(frame.rotation[i][j]);
  }
}

bool BoxSeparation::are_apart(const FloatBox& a, const FloatBox& b) const {
  const double(&r)[3][3] = frame_.rotation;
  double half_a[3], half_b[3], centre_b[3], offset[3];
  const double scale_a = 0.5 * frame_.units_a;
  const double scale_b = 0.5 * frame_.units_b;
  for (int k = 0; k < 3; ++k) {
    half_a[k] = (double{a.max[k]} - a.min[k]) * scale_a;
    half_b[k] = (double{b.max[k]} - b.min[k]) * scale_b;
    centre_b[k] = (double{b.max[k]} + b.min[k]) * scale_b;
  }
  for (int i = 0; i < 3; ++i) {
    const double centre_a = (double{a.max[i]} + a.min[i]) * scale_a;
    offset[i] = frame_.translation[i] - centre_a + r[i][0] * centre_b[0] + r[i][1] * centre_b[1] +
                r[i][2] * centre_b[2];
  }
  return are_boxes_apart({r, size_, offset, half_a, half_b}, frame_.slack);
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

}  // namespace graze::bvh
