#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/predicates/plane_sides.h>
#include <cmath>

namespace graze::narrowphase {

PlaneSides sides_of_plane(const Corners<double>& plane, const Corners<double>& other) {
  PlaneSides sides;
  for (int i = 0; i < 3; ++i) {
    sides.sign[i] = orientation_3d(plane.point[0], plane.point[1], plane.point[2], other.point[i]);
  }
  return sides;
}

PlaneSides sides_of_plane(const Corners<std::int64_t>& plane, const Corners<std::int64_t>& other) {
  const FixedNormal normal = normal_of(plane.point[0], plane.point[1], plane.point[2]);
  PlaneSides sides;
  for (int i = 0; i < 3; ++i)
    sides.sign[i] = side_of(normal, plane.point[0], other.point[i]);
  return sides;
}

/// Returns, of the axes along which the projection has area, the one with the largest, as it is
/// rounded: there the filters of orientations are most often sure.
int projection_axis(const Corners<double>& triangle) {
  int best = -1;
  double best_area = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 a = project(triangle.point[0], axis);
    const Point2 b = project(triangle.point[1], axis);
    const Point2 c = project(triangle.point[2], axis);
    if (orientation_2d(a, b, c) == Sign::Zero) continue;
    const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    if (best < 0 || area > best_area) {
      best = axis;
      best_area = area;
    }
  }
  return best;
}

int projection_axis(const Corners<std::int64_t>& triangle) {
  const FixedNormal normal = normal_of(triangle.point[0], triangle.point[1], triangle.point[2]);
  if (normal.x != 0) return 0;
  if (normal.y != 0) return 1;
  return normal.z != 0 ? 2 : -1;
}

}  // namespace graze::narrowphase
