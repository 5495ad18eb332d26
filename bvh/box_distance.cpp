#include <graze/bvh/box_distance.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

double squared_gap(double offset, double reach) {
  const double gap = offset - reach;
  return gap > 0 ? gap * gap : 0;  // NaN becomes 0
}

}  // namespace

BoxDistance::BoxDistance(const RelativeFrame& frame) : frame_(frame) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      size_[i][j] = std::abs(frame.rotation[i][j]);
  }
}

void BoxDistance::set_direction(const double (&direction)[3]) {
  for (int k = 0; k < 3; ++k) {
    direction_[k] = direction[k];
    size_in_a_[k] = std::abs(direction[k]);
    size_in_b_[k] =
        std::abs(direction[0] * frame_.rotation[0][k] + direction[1] * frame_.rotation[1][k] +
                 direction[2] * frame_.rotation[2][k]);
  }
}

// In the frame of A the difference of two points has components of at least the gaps between box A
// and the box around B that is aligned with it; so has it in the frame of B, with the roles
// exchanged. Each triple of gaps, squared and summed, is a lower bound; so is the square of the gap
// along any direction.
BoxGap BoxDistance::gap(const FloatBox& a, const FloatBox& b) const {
  const double(&r)[3][3] = frame_.rotation;
  const double(&s)[3][3] = size_;
  const double scale_a = 0.5 * frame_.units_a;
  const double scale_b = 0.5 * frame_.units_b;
  double half_a[3], half_b[3], centre_b[3], d[3];
  for (int k = 0; k < 3; ++k) {
    half_a[k] = (double{a.max[k]} - a.min[k]) * scale_a;
    half_b[k] = (double{b.max[k]} - b.min[k]) * scale_b;
    centre_b[k] = (double{b.max[k]} + b.min[k]) * scale_b;
  }
  double between = 0;
  double along = 0;
  double reach_along = frame_.slack;
  for (int i = 0; i < 3; ++i) {
    const double centre_a = (double{a.max[i]} + a.min[i]) * scale_a;
    d[i] = frame_.translation[i] - centre_a + r[i][0] * centre_b[0] + r[i][1] * centre_b[1] +
           r[i][2] * centre_b[2];
    between += d[i] * d[i];
    along += d[i] * direction_[i];
    reach_along += half_a[i] * size_in_a_[i] + half_b[i] * size_in_b_[i];
  }
  const double bound_along = squared_gap(along, reach_along);
  if (bound_along > limit_) return {bound_along, between};
  double in_a = 0;
  for (int i = 0; i < 3; ++i) {
    const double reach =
        half_a[i] + half_b[0] * s[i][0] + half_b[1] * s[i][1] + half_b[2] * s[i][2];
    in_a += squared_gap(std::abs(d[i]), reach + frame_.slack);
  }
  if (in_a > limit_) return {in_a, between};
  double in_b = 0;
  for (int j = 0; j < 3; ++j) {
    const double offset = d[0] * r[0][j] + d[1] * r[1][j] + d[2] * r[2][j];
    const double reach =
        half_b[j] + half_a[0] * s[0][j] + half_a[1] * s[1][j] + half_a[2] * s[2][j];
    in_b += squared_gap(std::abs(offset), reach + frame_.slack);
  }
  return {std::max(std::max(in_a, in_b), bound_along), between};
}

}  // namespace graze::bvh
