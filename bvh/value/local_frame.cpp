#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/value/power_of_two.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace graze::bvh {
namespace {

/// Returns the next float away from zero on the side of its sign, which zero is given beforehand.
float away_from_zero(float value) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) + 1);
}

float towards_zero(float value) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) - 1);
}

}  // namespace

float rounded_up(double value) {
  const float nearest = static_cast<float>(value);
  if (nearest == 0) return std::bit_cast<float>(std::uint32_t{1});
  return nearest > 0 ? away_from_zero(nearest) : towards_zero(nearest);
}

float rounded_down(double value) {
  return -rounded_up(-value);
}

LocalFrame LocalFrame::around(const Aabb& box) {
  LocalFrame frame;
  double half = 0;
  for (int k = 0; k < 3; ++k) {
    const double low = box.min.data()[k];
    const double high = box.max.data()[k];
    frame.centre[k] = 0.5 * low + 0.5 * high;  // in this order no sum overflows
    half = std::max(half, std::max(high - frame.centre[k], frame.centre[k] - low));
  }
  frame.exponent = half == 0 ? kMinExponent : std::max(std::ilogb(half), kMinExponent);
  return frame;
}

// The subtraction is off by 2^-53 of its result, the conversion to float by half a float's ulp,
// each relative to the same value: together less than the one ulp that rounded_down and rounded_up
// step.
FloatBox LocalFrame::to_local(const Aabb& box) const {
  const double scale = power_of_two(-exponent);
  FloatBox local;
  for (int k = 0; k < 3; ++k) {
    local.min[k] = rounded_down((box.min.data()[k] - centre[k]) * scale);
    local.max[k] = rounded_up((box.max.data()[k] - centre[k]) * scale);
  }
  return local;
}

double LocalFrame::unit() const {
  return power_of_two(exponent);
}

}  // namespace graze::bvh
