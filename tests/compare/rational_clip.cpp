#include <gmpxx.h>

#include <tests/compare/rational_clip.h>
#include <array>
#include <vector>

namespace graze::oracle {
namespace {

using Point = std::array<mpq_class, 3>;
using Polygon = std::vector<Point>;

struct HalfSpace {  // the points with normal.x <= offset
  Point normal;
  mpq_class offset;
};

Point exactly(const Eigen::Vector3d& p) {
  return {mpq_class(p.data()[0]), mpq_class(p.data()[1]), mpq_class(p.data()[2])};
}

Polygon exactly(const Triangle& t) {
  return {exactly(t.a), exactly(t.b), exactly(t.c)};
}

Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

mpq_class dot(const Point& p, const Point& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

HalfSpace below(const Point& normal, const Point& through) {
  return {normal, dot(normal, through)};
}

HalfSpace opposite(const HalfSpace& space) {
  const Point& n = space.normal;
  return {{-n[0], -n[1], -n[2]}, -space.offset};
}

// Sutherland and Hodgman. Points on the border stay, so that touching polygons, and polygons that
// are segments or points, leave something.
Polygon clip(const Polygon& polygon, const HalfSpace& space) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    const Point& q = polygon[(i + 1) % polygon.size()];
    const mpq_class over_p = dot(space.normal, p) - space.offset;
    const mpq_class over_q = dot(space.normal, q) - space.offset;
    if (over_p <= 0) result.push_back(p);
    if (sgn(over_p) * sgn(over_q) < 0) {
      const mpq_class t = over_p / (over_p - over_q);
      const Point d = minus(q, p);
      result.push_back({p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]});
    }
  }
  return result;
}

}  // namespace

bool intersects_by_clipping(const Triangle& triangle, const Aabb& box) {
  Polygon polygon = exactly(triangle);
  for (int axis = 0; axis < 3; ++axis) {
    Point normal;
    normal[axis] = 1;
    polygon = clip(polygon, below(normal, exactly(box.max)));
    polygon = clip(polygon, opposite(below(normal, exactly(box.min))));
  }
  return !polygon.empty();
}

std::optional<bool> intersects_by_clipping(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Polygon b = exactly(triangle_b);
  const Point normal = cross(minus(b[1], b[0]), minus(b[2], b[0]));
  if (normal == Point{}) return std::nullopt;
  Polygon polygon = exactly(triangle_a);
  const HalfSpace plane = below(normal, b[0]);
  polygon = clip(clip(polygon, plane), opposite(plane));
  for (int i = 0; i < 3; ++i) {
    const Point outward = cross(minus(b[(i + 1) % 3], b[i]), normal);
    polygon = clip(polygon, below(outward, b[i]));
  }
  return !polygon.empty();
}

}  // namespace graze::oracle
