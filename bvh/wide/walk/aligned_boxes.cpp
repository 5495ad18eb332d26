#include <graze/bvh/value/dot.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/wide/tree/wide_bounds.h>
#include <graze/bvh/wide/walk/aligned_boxes.h>

#include <cmath>

namespace graze::bvh {
namespace {

void round(AlignedTransform& transform, double unit, double slack) {
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i)
      transform.rows[k][i] = static_cast<float>(transform.axes[k][i]);
  }
  transform.unit = static_cast<float>(unit);
  transform.slack = rounded_up(slack + kWideUnderflow);
}

}  // namespace

bool set_axes(double (&axes)[3][3], const double (&direction)[3]) {
  const double square = dot(direction, direction);
  if (!(square > 0.5 && square < 2)) return false;
  int least = 0;
  for (int i = 0; i < 3; ++i) {
    axes[0][i] = direction[i] / std::sqrt(square);
    if (std::abs(axes[0][i]) < std::abs(axes[0][least])) least = i;
  }
  const double share = axes[0][least];
  const double length = std::sqrt(1 - share * share);  // above 0.8
  for (int i = 0; i < 3; ++i)
    axes[1][i] = ((i == least ? 1 : 0) - share * axes[0][i]) / length;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    axes[2][i] = axes[0][j] * axes[1][k] - axes[0][k] * axes[1][j];
  }
  return true;
}

void align_to(AlignedTransform (&transforms)[2], const RelativeFrame& b_in_a,
              const double (&axes)[3][3], const double (&point)[3]) {
  AlignedTransform& a = transforms[0];
  AlignedTransform& b = transforms[1];
  for (int k = 0; k < 3; ++k) {
    const double* axis = axes[k];
    double between[3];
    for (int i = 0; i < 3; ++i) {
      const double turned = b_in_a.rotation[0][i] * axis[0] + b_in_a.rotation[1][i] * axis[1] +
                            b_in_a.rotation[2][i] * axis[2];
      a.axes[k][i] = axis[i] * b_in_a.units_a;
      b.axes[k][i] = turned * b_in_a.units_b;
      between[i] = b_in_a.translation[i] - point[i];
    }
    a.offset[k] = -dot(axis, point);
    b.offset[k] = dot(axis, between);
  }
  round(a, b_in_a.units_a, 0);
  round(b, b_in_a.units_b, 3 * b_in_a.slack);
}

bool align_along(AlignedTransform (&transforms)[2], const RelativeFrame& b_in_a,
                 const double (&direction)[3], const double (&point)[3]) {
  double axes[3][3];
  if (!set_axes(axes, direction)) return false;
  align_to(transforms, b_in_a, axes, point);
  return true;
}

}  // namespace graze::bvh
