#pragma once

#include <algorithm>
#include <limits>

namespace graze::bvh {

/// A closed box of floats in the units and about the centre of a LocalFrame. Every float box holds
/// what it was made from: it is rounded outward (law 5).
struct FloatBox {
  float min[3];
  float max[3];
};

// These are static so that each source compiles its own: an inline function is shared by the
// linker, and the copy that it keeps could be one compiled with a user's -ffast-math.

/// Returns the box that every merge leaves unchanged: it holds nothing.
static inline FloatBox empty_box() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

/// Returns the smallest box that holds both, exactly.
static inline FloatBox merged(const FloatBox& a, const FloatBox& b) {
  FloatBox box;
  for (int k = 0; k < 3; ++k) {
    box.min[k] = std::min(a.min[k], b.min[k]);
    box.max[k] = std::max(a.max[k], b.max[k]);
  }
  return box;
}

/// True unless the closed boxes, in one frame, share no point.
static inline bool overlap(const FloatBox& a, const FloatBox& b) {
  bool is_overlapping = true;
  for (int k = 0; k < 3; ++k) {
    is_overlapping &= a.min[k] <= b.max[k] && b.min[k] <= a.max[k];
  }
  return is_overlapping;
}

/// Returns half the surface of the box, in square local units: the measure of the surface area
/// heuristic.
static inline float half_surface(const FloatBox& box) {
  const float x = box.max[0] - box.min[0];
  const float y = box.max[1] - box.min[1];
  const float z = box.max[2] - box.min[2];
  return x * y + y * z + z * x;
}

}  // namespace graze::bvh
