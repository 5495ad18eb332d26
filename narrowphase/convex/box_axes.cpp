#include <graze/narrowphase/convex/box_axes.h>
#include <graze/narrowphase/convex/segments.h>

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
  const Vec3 between = box_b.at - box_a.at;
  Vec3 best;
  double depth = std::numeric_limits<double>::infinity();
  int edge_a = -1, edge_b = -1;
  const auto reach_past = [&](const Vec3& axis, double along_axis) {
    return (reach_of(box_a, axis) + reach_of(box_b, axis)) - std::abs(along_axis);
  };
  // Axes of boxes are of length 1 as far as poses are rotations: near enough to compare by.
  for (const Core* box : {&box_a, &box_b}) {
    for (const Vec3& axis : box->axis) {
      const double along_axis = dot(axis, between);
      const double found = reach_past(axis, along_axis);
      if (!(found < depth)) continue;
      depth = found;
      best = along_axis < 0 ? -axis : axis;
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 product = cross(box_a.axis[i], box_b.axis[j]);
      if (!(largest(product) > kParallel)) continue;
      const double along_axis = dot(product, between);
      const double found = reach_past(product, along_axis);
      const double size = dot(product, product);
      const double wanted = kEdgeGain * depth;
      if (found > 0 && wanted > 0 && found * found >= (wanted * wanted) * size) continue;
      const double of_unit = found / std::sqrt(size);
      if (!(of_unit < wanted)) continue;
      depth = of_unit;
      best = along_axis < 0 ? -product : product;
      edge_a = i, edge_b = j;
    }
  }
  best = unit_or(best, {0, 0, 1});
  Penetration way = along(box_a, box_b, best);
  if (edge_a < 0) return way;
  const BoxEdge of_a = edge_along(box_a, edge_a, best);
  const BoxEdge of_b = edge_along(box_b, edge_b, -best);
  const NearestPoints met = nearest_of_segments(of_a.from, of_a.to, of_b.from, of_b.to);
  way.point_a = met.point_a;
  way.point_b = met.point_b;
  way.has_witnesses = true;
  return way;
}

BoxEdge edge_along(const Core& box, int axis, const Vec3& direction) {
  const double half[3] = {box.half.x, box.half.y, box.half.z};
  Vec3 middle = box.at;
  for (int k = 0; k < 3; ++k) {
    if (k == axis) continue;
    middle = middle + box.axis[k] * (dot(box.axis[k], direction) < 0 ? -half[k] : half[k]);
  }
  const Vec3 reach = box.axis[axis] * half[axis];
  return {middle - reach, middle + reach};
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
