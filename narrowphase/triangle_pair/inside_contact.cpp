// Where `other` reaches through the plane, its section is a closed segment of positive length, and
// it meets the open one that its plane cuts out of the triangle if and only if their insides meet:
// that is crosses(). Otherwise what lies in the plane is the hull of corners. A closed convex set
// and an open convex polygon of a plane are apart if and only if the line of an edge of one of them
// has the other on its far side, or on itself.

#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/plane_sides.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/inside_contact.h>

#include <algorithm>
#include <span>

namespace graze::narrowphase {
namespace {

Sign turn_of(const Point2 (&corners)[3]) {
  return orientation_2d(corners[0], corners[1], corners[2]);
}

/// True if all points lie on the side `far` of the line, or on it.
bool are_beyond(Point2 from, Point2 to, Sign far, std::span<const Point2> points) {
  return std::all_of(points.begin(), points.end(),
                     [&](Point2 point) { return orientation_2d(from, to, point) != -far; });
}

/// True if the hull of up to three corners, no three of which are on one line, meets the inside.
bool hull_meets_inside(std::span<const Point2> hull, const Point2 (&triangle)[3]) {
  const Sign turn = turn_of(triangle);
  for (int i = 0; i < 3; ++i) {
    if (are_beyond(triangle[i], triangle[(i + 1) % 3], -turn, hull)) return false;
  }
  if (hull.size() == 2) {
    return !are_beyond(hull[0], hull[1], Sign::Positive, triangle) &&
           !are_beyond(hull[0], hull[1], Sign::Negative, triangle);
  }
  if (hull.size() == 3) {
    const Sign turn_of_hull = orientation_2d(hull[0], hull[1], hull[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (are_beyond(hull[i], hull[(i + 1) % 3], -turn_of_hull, triangle)) return false;
    }
  }
  return true;
}

}  // namespace

bool meets_inside(const Triangle& other, const Triangle& triangle) {
  const Corners<double> corners = corners_of(triangle);
  const Corners<double> others = corners_of(other);
  const PlaneSides sides = sides_of_plane(corners, others);
  if (sides.are_on_both()) return decide(other, triangle, Touch::Exclude).is_hit;
  const int axis = projection_axis(corners);
  Point2 in_plane[3];
  std::size_t count = 0;
  for (int i = 0; i < 3; ++i) {
    if (sides.sign[i] == Sign::Zero) in_plane[count++] = project(others.point[i], axis);
  }
  if (count == 0) return false;
  return hull_meets_inside({in_plane, count},
                           {project(corners.point[0], axis), project(corners.point[1], axis),
                            project(corners.point[2], axis)});
}

bool turn_alike(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Corners<double> a = corners_of(triangle_a);
  const Corners<double> b = corners_of(triangle_b);
  const int axis = projection_axis(a);
  const auto seen = [&](const Corners<double>& corners) {
    return orientation_2d(project(corners.point[0], axis), project(corners.point[1], axis),
                          project(corners.point[2], axis));
  };
  return seen(a) == seen(b);
}

}  // namespace graze::narrowphase
