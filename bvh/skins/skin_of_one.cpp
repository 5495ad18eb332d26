#include <graze/bvh/skins/skin_of_one.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

/// Returns the middle of an interval. half_width() says how far from it the interval reaches:
/// differences of floats are exact in double unless their sizes are 2^29 apart, and then off by
/// less than a float's step.
float middle(float low, float high) {
  return static_cast<float>(0.5 * (double{low} + high));
}

float half_width(float low, float high) {
  const double centre = middle(low, high);
  return rounded_up(std::max(high - centre, centre - low));
}

}  // namespace

FloatObb obb_around(const FloatBox& box) {
  FloatObb obb{};
  for (int k = 0; k < 3; ++k) {
    obb.axes[k][k] = 1;
    obb.centre[k] = middle(box.min[k], box.max[k]);
    obb.half[k] = half_width(box.min[k], box.max[k]);
  }
  return obb;
}

FloatSphere sphere_around(const FloatBox& box) {
  FloatSphere sphere;
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    sphere.centre[k] = middle(box.min[k], box.max[k]);
    const double half = half_width(box.min[k], box.max[k]);
    square += half * half;
  }
  sphere.radius = rounded_up(std::sqrt(square));
  return sphere;
}

FloatKDop kdop_around(const FloatBox& box) {
  FloatKDop kdop;
  for (int slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    double low = 0;
    double high = 0;
    for (int k = 0; k < 3; ++k) {
      const int direction = kKDopDirections<18>[slab][k];
      if (direction > 0) low += box.min[k];
      if (direction > 0) high += box.max[k];
      if (direction < 0) low -= box.max[k];
      if (direction < 0) high -= box.min[k];
    }
    // A sum of two floats is off by 2^-53 of itself: less than the step.
    kdop.min[slab] = rounded_down(low);
    kdop.max[slab] = rounded_up(high);
  }
  return kdop;
}

FloatKDop kdop_around(const FloatSphere& sphere) {
  FloatKDop kdop;
  for (int slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    const auto& d = kKDopDirections<18>[slab];
    const int ones = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double along = double{sphere.centre[0]} * d[0] + double{sphere.centre[1]} * d[1] +
                         double{sphere.centre[2]} * d[2];
    const double radius = sphere.radius * std::sqrt(static_cast<double>(ones));
    // Three roundings to double; a float's step is relative to a sum that may cancel.
    const double margin = 0x1p-50 * (std::abs(along) + radius) + 0x1p-100;
    kdop.min[slab] = rounded_down(along - radius - margin);
    kdop.max[slab] = rounded_up(along + radius + margin);
  }
  return kdop;
}

FloatSphere to_local(const LocalFrame& frame, const Sphere& sphere) {
  const double scale = std::ldexp(1.0, -frame.exponent);
  FloatSphere local;
  double error = 0;  // the error of the centre, in the sum of its coordinates
  for (int k = 0; k < 3; ++k) {
    const double centre = (sphere.centre.data()[k] - frame.centre[k]) * scale;
    local.centre[k] = static_cast<float>(centre);
    error += std::abs(centre - local.centre[k]) + 0x1p-52 * std::abs(centre);
  }
  local.radius = rounded_up(sphere.radius * scale + error + 0x1p-100);
  return local;
}

}  // namespace graze::bvh
