#include <graze/engine/world/contacts/meshes/triangle_axes.h>

#include <algorithm>

namespace graze {

using narrowphase::Vec3;

namespace {

// A share of the largest coordinate that is more than the slack of any search, 2^-46 of the pair's
// scale, which is at most 12 times that coordinate.
constexpr double kMargin = 0x1p-38;

// Edges are so nearly parallel below this sine that their cross product has no meaningful
// direction.
constexpr double kParallelSine = 1e-6;

struct Range {
  double low;
  double high;
};

Range along(const Vec3& axis, const Vec3 (&triangle)[3], const Vec3& from) {
  const double s = dot(axis, triangle[0] - from);
  const double t = dot(axis, triangle[1] - from);
  const double u = dot(axis, triangle[2] - from);
  return {std::min(std::min(s, t), u), std::max(std::max(s, t), u)};
}

}  // namespace

SureVerdict decide_by_axes(const Vec3 (&a)[3], const Vec3 (&b)[3]) {
  double most = 0;
  for (int i = 0; i < 3; ++i)
    most = std::max({most, largest(a[i]), largest(b[i])});
  const double margin = kMargin * most;
  bool is_sure = true;
  const auto parts = [&](const Vec3& axis, double size) {
    const Range of_a = along(axis, a, a[0]), of_b = along(axis, b, a[0]);
    const double gap = std::max(of_b.low - of_a.high, of_a.low - of_b.high);
    is_sure &= gap < -margin * size;
    return gap > margin * size;
  };
  Vec3 edge_a[3], edge_b[3];
  double length_a[3], length_b[3];
  for (int i = 0; i < 3; ++i) {
    edge_a[i] = a[(i + 1) % 3] - a[i], edge_b[i] = b[(i + 1) % 3] - b[i];
    length_a[i] = length(edge_a[i]), length_b[i] = length(edge_b[i]);
  }
  for (const Vec3& normal : {cross(edge_b[0], edge_b[1]), cross(edge_a[0], edge_a[1])})
    if (parts(normal, length(normal))) return SureVerdict::Apart;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 axis = cross(edge_a[i], edge_b[j]);
      const double size = length(axis);
      is_sure &= size > kParallelSine * length_a[i] * length_b[j];
      if (parts(axis, size)) return SureVerdict::Apart;
    }
  }
  return is_sure ? SureVerdict::Meet : SureVerdict::Unsure;
}

}  // namespace graze
