#include <graze/narrowphase/coplanar.h>
#include <algorithm>

namespace graze::narrowphase {
namespace {

bool ranges_overlap(double a0, double a1, double b0, double b1) {
  return std::min(a0, a1) <= std::max(b0, b1) && std::min(b0, b1) <= std::max(a0, a1);
}

bool are_on_one_side(Sign s, Sign t) {
  return s != Sign::Zero && s == t;
}

/// Two closed segments in the plane meet if and only if their boxes overlap and neither lies
/// strictly on one side of the other's line. A point's line holds every point, so that the other
/// segment's line and the boxes decide for it.
bool segments_intersect(Point2 a0, Point2 a1, Point2 b0, Point2 b1) {
  return ranges_overlap(a0.x, a1.x, b0.x, b1.x) && ranges_overlap(a0.y, a1.y, b0.y, b1.y) &&
         !are_on_one_side(orientation_2d(a0, a1, b0), orientation_2d(a0, a1, b1)) &&
         !are_on_one_side(orientation_2d(b0, b1, a0), orientation_2d(b0, b1, a1));
}

/// Closed containment. A triangle without area contains nothing here: it is the union of its edges,
/// which are tested by themselves.
bool contains(const Point2* triangle, Point2 point) {
  bool has_positive = false;
  bool has_negative = false;
  for (int i = 0; i < 3; ++i) {
    const Sign sign = orientation_2d(triangle[i], triangle[(i + 1) % 3], point);
    has_positive |= sign == Sign::Positive;
    has_negative |= sign == Sign::Negative;
  }
  return has_positive != has_negative;
}

}  // namespace

bool projections_intersect(const Corners& triangle_a, const Corners& triangle_b, int axis) {
  Point2 a[3];
  Point2 b[3];
  for (int i = 0; i < 3; ++i) {
    a[i] = project(triangle_a.point[i], axis);
    b[i] = project(triangle_b.point[i], axis);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (segments_intersect(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3])) return true;
    }
  }
  // No edges meet: either one holds the other whole, or they are apart.
  return contains(b, a[0]) || contains(a, b[0]);
}

bool segments_intersect(const double* a0, const double* a1, const double* b0, const double* b1) {
  // Four points in one plane: along at least one axis the projection of that plane is one to one,
  // and there the projections meet if and only if the segments do. In the others they meet if those
  // do. If the four points are collinear the same holds of their line.
  if (orientation_3d(a0, a1, b0, b1) != Sign::Zero) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!segments_intersect(project(a0, axis), project(a1, axis), project(b0, axis),
                            project(b1, axis))) {
      return false;
    }
  }
  return true;
}

}  // namespace graze::narrowphase
