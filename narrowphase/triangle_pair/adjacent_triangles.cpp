#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/coplanar.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <graze/narrowphase/triangle_triangle.h>

namespace graze::narrowphase {
namespace {

bool contains(const Triangle& triangle, const Eigen::Vector3d& point) {
  return intersects_exactly({point, point, point}, triangle);
}

/// Both vertices are strictly on one side of the plane of `plane`, which then holds no more of the
/// edge between them nor of the triangle that they form with a point of the plane.
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
  if (are_on_one_side(triangle_b, triangle_a.b, triangle_a.c)) return false;
  if (are_on_one_side(triangle_a, triangle_b.b, triangle_b.c)) return false;
  return leaves_into(triangle_a, triangle_b) || leaves_into(triangle_b, triangle_a);
}

bool intersect_beyond_edge(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Corners<double> a = corners_of(triangle_a);
  const Corners<double> b = corners_of(triangle_b);
  if (orientation_3d(a.point[0], a.point[1], a.point[2], b.point[2]) != Sign::Zero) return false;
  const bool is_segment_a = is_degenerate(triangle_a);
  const bool is_segment_b = is_degenerate(triangle_b);
  // The line of the edge holds all of a segment, and of a triangle nothing but the edge.
  if (is_segment_a != is_segment_b) return false;
  if (is_segment_a) {
    const Triangle edge{triangle_a.a, triangle_a.b, triangle_a.b};
    return (contains(triangle_b, triangle_a.c) && !contains(edge, triangle_a.c)) ||
           (contains(triangle_a, triangle_b.c) && !contains(edge, triangle_b.c));
  }
  // In one plane: they overlap if both lie on the same side of the edge.
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 from = project(a.point[0], axis);
    const Point2 to = project(a.point[1], axis);
    const Sign side = orientation_2d(from, to, project(a.point[2], axis));
    if (side != Sign::Zero) return side == orientation_2d(from, to, project(b.point[2], axis));
  }
  return false;
}

}  // namespace graze::narrowphase
