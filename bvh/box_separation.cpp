#include <graze/bvh/box_separation.h>

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
  const double(&s)[3][3] = size_;
  const double slack = frame_.slack;
  double half_a[3], half_b[3], centre_b[3], d[3];
  const double scale_a = 0.5 * frame_.units_a;
  const double scale_b = 0.5 * frame_.units_b;
  for (int k = 0; k < 3; ++k) {
    half_a[k] = (double{a.max[k]} - a.min[k]) * scale_a;
    half_b[k] = (double{b.max[k]} - b.min[k]) * scale_b;
    centre_b[k] = (double{b.max[k]} + b.min[k]) * scale_b;
  }
  // Comparisons are such that a slack or a distance that is NaN or infinite never proves anything.
  for (int i = 0; i < 3; ++i) {
    const double centre_a = (double{a.max[i]} + a.min[i]) * scale_a;
    d[i] = frame_.translation[i] - centre_a + r[i][0] * centre_b[0] + r[i][1] * centre_b[1] +
           r[i][2] * centre_b[2];
    const double reach =
        half_a[i] + half_b[0] * s[i][0] + half_b[1] * s[i][1] + half_b[2] * s[i][2];
    if (std::abs(d[i]) > reach + slack) return true;
  }
  for (int j = 0; j < 3; ++j) {
    const double distance = d[0] * r[0][j] + d[1] * r[1][j] + d[2] * r[2][j];
    const double reach =
        half_b[j] + half_a[0] * s[0][j] + half_a[1] * s[1][j] + half_a[2] * s[2][j];
    if (std::abs(distance) > reach + slack) return true;
  }
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      const double distance = d[i2] * r[i1][j] - d[i1] * r[i2][j];
      const double reach = half_a[i1] * s[i2][j] + half_a[i2] * s[i1][j] + half_b[j1] * s[i][j2] +
                           half_b[j2] * s[i][j1];
      if (std::abs(distance) > reach + slack) return true;
    }
  }
  return false;
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
