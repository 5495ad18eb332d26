#include <graze/engine/world/shape.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

constexpr double kLargestDouble = std::numeric_limits<double>::max();

// A computed distance is off by less than this share of itself, beyond the room that boxes have
// (shape_bounds.cpp).
constexpr double kDistanceRounding = 0x1p-44;

}  // namespace

double width_of(const Aabb& box) {
  double most = 0;
  for (int i = 0; i < 3; ++i)
    most = std::max(most, box.max.data()[i] - box.min.data()[i]);
  return std::min(most, kLargestLength);
}

Aabb grown(const Aabb& box, double width) {
  Aabb larger;
  const double room = width + kDistanceRounding * width;
  for (int i = 0; i < 3; ++i) {
    const double low = std::nextafter(box.min.data()[i] - room, -kLargestDouble);
    const double high = std::nextafter(box.max.data()[i] + room, kLargestDouble);
    larger.min.data()[i] = std::max(low, -kLargestDouble);
    larger.max.data()[i] = std::min(high, kLargestDouble);
  }
  return larger;
}

bool share_a_point(const Aabb& s, const Aabb& t) {
  for (int i = 0; i < 3; ++i) {
    if (s.min.data()[i] > t.max.data()[i] || t.min.data()[i] > s.max.data()[i]) return false;
  }
  return true;
}

}  // namespace graze
