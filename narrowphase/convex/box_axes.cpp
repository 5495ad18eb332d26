#include <graze/narrowphase/convex/box_axes.h>

#include <initializer_list>

namespace graze::narrowphase {
namespace {

// Edges at a smaller angle than about this give no axis of their own: faces do as well there.
constexpr double kParallel = 1e-6;
constexpr double kEdgeGain = 0.95;

}  // namespace

Penetration least_axis(const Core& box_a, const Core& box_b) {
  const Vec3 way = box_b.at - box_a.at;
  Penetration best{};
  bool is_first = true;
  const auto offer = [&](const Vec3& axis, double gain) {
    const Vec3 toward = dot(axis, way) < 0 ? -axis : axis;
    const Penetration found = along(box_a, box_b, toward);
    if (is_first || found.depth < gain * best.depth) best = found;
    is_first = false;
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
  return best;
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
