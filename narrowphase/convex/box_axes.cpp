#include <graze/narrowphase/convex/box_axes.h>

#include <initializer_list>
#include <limits>

namespace graze::narrowphase {
namespace {

// Edges at a smaller angle than about this give no axis of their own: faces do as well there.
constexpr double kParallel = 1e-6;
constexpr double kEdgeGain = 0.95;

/// How far the box reaches from its middle along a direction, either way.
double reach_of(const Core& box, const Vec3& direction) {
  return (std::abs(dot(box.axis[0], direction)) * box.half.x +
          std::abs(dot(box.axis[1], direction)) * box.half.y) +
         std::abs(dot(box.axis[2], direction)) * box.half.z;
}

}  // namespace

Penetration least_axis(const Core& box_a, const Core& box_b) {
  const Vec3 way = box_b.at - box_a.at;
  Vec3 best;
  double depth = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Vec3& axis, double gain) {
    const double along_axis = dot(axis, way);
    const double found = reach_of(box_a, axis) + reach_of(box_b, axis) - std::abs(along_axis);
    if (!(found < gain * depth)) return;
    depth = found;
    best = along_axis < 0 ? -axis : axis;
  };
  for (const Core* box : {&box_a, &box_b}) {
    for (const Vec3& axis : box->axis)
      offer(unit_or(axis, {0, 0, 1}), 1);
  }
  for (const Vec3& u : box_a.axis) {
    for (const Vec3& v : box_b.axis) {
      const Vec3 product = cross(u, v);
      if (largest(product) > kParallel) offer(unit_or(product, {0, 0, 1}), kEdgeGain);
    }
  }
  return along(box_a, box_b, best);
}

Penetration nearest_face(const Core& box, const Core& point) {
  Penetration best{};
  bool is_first = true;
  for (const Vec3& axis : box.axis) {
    for (const double sign : {1.0, -1.0}) {
      const Penetration found = along(box, point, unit_or(axis * sign, {0, 0, 1}));
      if (is_first || found.depth < best.depth) best = found;
      is_first = false;
    }
  }
  return best;
}

}  // namespace graze::narrowphase
