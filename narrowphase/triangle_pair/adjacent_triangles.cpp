#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/coplanar.h>
#include <graze/narrowphase/predicates/orientation_stages.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <cmath>
#include <optional>

namespace graze::narrowphase {
namespace {

bool contains(const Triangle& triangle, const Eigen::Vector3d& point) {
  return intersects_exactly({point, point, point}, triangle);
}

/// True if both vertices are strictly on one side of the plane of `plane`, which then holds no more
/// of the edge between them nor of the triangle that they form with a point of the plane.
bool are_on_one_side(const Triangle& plane, const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  const double* a = plane.a.data();
  const double* b = plane.b.data();
  const double* c = plane.c.data();
  const Sign side = orientation_3d(a, b, c, p.data());
  return side != Sign::Zero && side == orientation_3d(a, b, c, q.data());
}

/// Both triangles are star-shaped about the shared vertex `from.a`: if they share more, a ray from
/// it stays in both until it leaves one of them, through the opposite edge. True if some ray leaves
/// `from` while in `into`. A triangle without area is left at its vertices.
bool leaves_into(const Triangle& from, const Triangle& into) {
  if (!is_degenerate(from)) return intersects_exactly({from.b, from.c, from.c}, into);
  return (from.b != from.a && contains(into, from.b)) ||
         (from.c != from.a && contains(into, from.c));
}

/// Returns the axis along which a triangle looks largest, or nearly so: any axis is right.
int broad_axis(const Triangle& triangle) {
  const double* a = triangle.a.data();
  const double* b = triangle.b.data();
  const double* c = triangle.c.data();
  const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const double v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const double x = std::abs(u[1] * v[2] - u[2] * v[1]);
  const double y = std::abs(u[2] * v[0] - u[0] * v[2]);
  const double z = std::abs(u[0] * v[1] - u[1] * v[0]);
  if (x > y) return x > z ? 0 : 2;
  return y > z ? 1 : 2;
}

/// Says on which side of the line from `from` to `to` a point is: 1 or -1 if that is sure, else 0.
int sure_side(Point2 from, Point2 to, Point2 point) {
  const std::optional<Sign> side = orientation_2d_filter(from, to, point);
  return side.has_value() ? static_cast<int>(*side) : 0;
}

/// True if, seen along the axis, a line through the shared vertex surely has one triangle on one
/// side, where an edge may lie on it, and all of the other but the vertex strictly beyond. Then the
/// two share no other point: all of the other's points lie beyond the line. If any line does so,
/// one along an edge does.
bool are_seen_apart(const Triangle& triangle_a, const Triangle& triangle_b, int axis) {
  const FanSides sides =
      fan_filter(project(triangle_a.a.data(), axis), project(triangle_a.b.data(), axis),
                 project(triangle_a.c.data(), axis), project(triangle_b.b.data(), axis),
                 project(triangle_b.c.data(), axis));
  const int a = sides.a_b, b = sides.c_d;
  const bool is_b_beyond =
      (sides.a_c == -a && sides.a_d == -a) || (sides.b_c == a && sides.b_d == a);
  const bool is_a_beyond =
      (sides.a_c == b && sides.b_c == b) || (sides.a_d == -b && sides.b_d == -b);
  return (a != 0 && is_b_beyond) || (b != 0 && is_a_beyond);
}

/// True if, seen along the axis, the line of the shared edge surely has the rest of the two on
/// either side of it.
bool are_seen_beside(const Triangle& triangle_a, const Triangle& triangle_b, int axis) {
  const Point2 from = project(triangle_a.a.data(), axis), to = project(triangle_a.b.data(), axis);
  const int side = sure_side(from, to, project(triangle_a.c.data(), axis));
  return side != 0 && sure_side(from, to, project(triangle_b.c.data(), axis)) == -side;
}

}  // namespace

bool is_degenerate(const Triangle& triangle) {
  for (int axis = 0; axis < 3; ++axis) {
    const Corners<double> t = corners_of(triangle);
    if (orientation_2d(project(t.point[0], axis), project(t.point[1], axis),
                       project(t.point[2], axis)) != Sign::Zero) {
      return false;
    }
  }
  return true;
}

bool intersect_beyond_vertex(const Triangle& triangle_a, const Triangle& triangle_b) {
  // This decides nearly all neighbours on a surface without anything exact.
  const int axis = broad_axis(triangle_a);
  if (are_seen_apart(triangle_a, triangle_b, axis)) return false;
  const int other_axis = broad_axis(triangle_b);
  if (other_axis != axis && are_seen_apart(triangle_a, triangle_b, other_axis)) return false;
  if (are_on_one_side(triangle_b, triangle_a.b, triangle_a.c)) return false;
  if (are_on_one_side(triangle_a, triangle_b.b, triangle_b.c)) return false;
  return leaves_into(triangle_a, triangle_b) || leaves_into(triangle_b, triangle_a);
}

bool intersect_beyond_edge(const Triangle& triangle_a, const Triangle& triangle_b) {
  if (are_seen_beside(triangle_a, triangle_b, broad_axis(triangle_a))) return false;
  const Corners<double> a = corners_of(triangle_a);
  const Corners<double> b = corners_of(triangle_b);
  if (orientation_3d(a.point[0], a.point[1], a.point[2], b.point[2]) != Sign::Zero) return false;
  const bool is_segment_a = is_degenerate(triangle_a);
  const bool is_segment_b = is_degenerate(triangle_b);
  // The line of the edge holds all of a segment, and nothing but the edge of a triangle.
  if (is_segment_a != is_segment_b) return false;
  if (is_segment_a) {
    const Triangle edge{triangle_a.a, triangle_a.b, triangle_a.b};
    return (contains(triangle_b, triangle_a.c) && !contains(edge, triangle_a.c)) ||
           (contains(triangle_a, triangle_b.c) && !contains(edge, triangle_b.c));
  }
  // The two are in one plane: they overlap if both lie on the same side of the edge.
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 from = project(a.point[0], axis);
    const Point2 to = project(a.point[1], axis);
    const Sign side = orientation_2d(from, to, project(a.point[2], axis));
    if (side != Sign::Zero) return side == orientation_2d(from, to, project(b.point[2], axis));
  }
  return false;
}

}  // namespace graze::narrowphase
