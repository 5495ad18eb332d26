#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/depth/box_axes.h>

#include <algorithm>
#include <limits>

namespace graze::narrowphase {
namespace {

// The values are those of two boxes: edges at a smaller angle give no axis, and must gain a
// twentieth.
constexpr double kParallel = 1e-6;
constexpr double kEdgeGain = 0.95;

// Points are on one line along the normal to this share of the scale: kTouchTolerance of
// engine/world.
constexpr double kTouching = 0x1p-34;

double projected_radius(const Core& box, const Vec3& direction) {
  return (std::abs(dot(box.axis[0], direction)) * box.half.x +
          std::abs(dot(box.axis[1], direction)) * box.half.y) +
         std::abs(dot(box.axis[2], direction)) * box.half.z;
}

Vec3 outward(const Core& triangle) {
  return cross(triangle.corner[1] - triangle.corner[0], triangle.corner[2] - triangle.corner[0]);
}

class BoxAndTriangle {
 public:
  BoxAndTriangle(const Core& box, const Core& triangle) : box_(box), triangle_(triangle) {
    for (int i = 0; i < 3; ++i)
      corner_[i] = triangle.corner[i] - box.at;
  }

  Parting run() {
    offer(unit_or(outward(triangle_), {0, 0, 1}), 1, 1, -1, -1);
    for (const Vec3& axis : box_.axis)
      offer(axis, 1, 1, -1, -1);
    for (int e = 0; e < 3; ++e) {
      const Vec3 edge = corner_[(e + 1) % 3] - corner_[e];
      const double size = largest(edge);
      for (int k = 0; k < 3; ++k) {
        const Vec3 product = cross(box_.axis[k], edge);
        if (largest(product) > kParallel * size) offer(product, length(product), kEdgeGain, k, e);
      }
    }
    normal_ = unit_or(normal_, {0, 0, 1});
    Parting parting;
    parting.penetration = along(box_, triangle_, normal_);
    parting.penetration.depth = std::max(parting.penetration.depth, 0.0);
    if (axis_ >= 0) meet_at_edges(parting);
    return parting;
  }

 private:
  /// Offers an axis whose length is `size`: the triangle leaves by either end of it.
  void offer(const Vec3& axis, double size, double gain, int box_axis, int edge) {
    const double a = dot(corner_[0], axis), b = dot(corner_[1], axis), c = dot(corner_[2], axis);
    const double radius = projected_radius(box_, axis);
    const double up = radius - std::min(a, std::min(b, c));
    const double down = radius + std::max(a, std::max(b, c));
    const double found = std::min(up, down);
    if (!(found < gain * depth_ * size)) return;
    depth_ = found / size;
    normal_ = up <= down ? axis : -axis;
    axis_ = box_axis, edge_ = edge;
  }

  /// Takes as meeting points those of the box's edge that is farthest along the normal and the
  /// triangle's edge, unless its third corner is deeper.
  void meet_at_edges(Parting& parting) const {
    if (dot(corner_[(edge_ + 2) % 3] - corner_[edge_], normal_) < 0) return;
    const BoxEdge edge = edge_along(box_, axis_, normal_);
    const NearestPoints met = nearest_of_segments(edge.from, edge.to, triangle_.corner[edge_],
                                                  triangle_.corner[(edge_ + 1) % 3]);
    parting.penetration.point_a = met.point_a;
    parting.penetration.point_b = met.point_b;
    parting.has_witnesses = lie_along(parting.penetration, kTouching * pair_scale(box_, triangle_));
  }

  const Core& box_;
  const Core& triangle_;
  Vec3 corner_[3];  ///< the corners as seen from the middle of the box
  Vec3 normal_;
  double depth_ = std::numeric_limits<double>::infinity();
  /// The normal is the cross product of this axis of the box and this edge of the triangle, unless
  /// they are -1.
  int axis_ = -1;
  int edge_ = -1;
};

Parting part_point(const Core& point, const Core& triangle) {
  Parting parting;
  Penetration& penetration = parting.penetration;
  penetration.point_b = nearest_on_triangle(triangle, point.at);
  const Vec3 between = penetration.point_b - point.at;
  const double distance = length(between);
  penetration.normal = distance > 0x1p-40 * (point.radius + pair_scale(point, triangle))
                           ? between * (1 / distance)
                           : -unit_or(outward(triangle), {0, 0, 1});
  penetration.depth = std::max(point.radius - distance, 0.0);
  penetration.point_a = point.at + penetration.normal * point.radius;
  parting.has_witnesses = true;
  return parting;
}

}  // namespace

Parting part_from_triangle(const Core& core, const Core& triangle) {
  return core.kind == CoreKind::Box ? BoxAndTriangle(core, triangle).run()
                                    : part_point(core, triangle);
}

}  // namespace graze::narrowphase
