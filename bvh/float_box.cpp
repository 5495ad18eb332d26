#include <graze/bvh/float_box.h>

#include <algorithm>
#include <limits>

namespace graze::bvh {

FloatBox empty_box() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

FloatBox merged(const FloatBox& a, const FloatBox& b) {
  FloatBox box;
  for (int k = 0; k < 3; ++k) {
    box.min[k] = std::min(a.min[k], b.min[k]);
    box.max[k] = std::max(a.max[k], b.max[k]);
  }
  return box;
}

bool overlap(const FloatBox& a, const FloatBox& b) {
  bool is_overlapping = true;
  for (int k = 0; k < 3; ++k) {
    is_overlapping &= a.min[k] <= b.max[k] && b.min[k] <= a.max[k];
  }
  return is_overlapping;
}

float half_surface(const FloatBox& box) {
  const float x = box.max[0] - box.min[0];
  const float y = box.max[1] - box.min[1];
  const float z = box.max[2] - box.min[2];
  return x * y + y * z + z * x;
}

}  // namespace graze::bvh
