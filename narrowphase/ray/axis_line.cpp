#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/ray/axis_line.h>
#include <algorithm>

namespace graze::narrowphase {
namespace {

using Corners3 = const double* const (&)[3];

/// Describes the plane across the line. The moved point is shifted by more along `major` than along
/// `minor`, by as much as e is more than e^2.
struct Across {
  int major;
  int minor;
};

constexpr Across kAcross[3] = {{1, 2}, {0, 2}, {0, 1}};

/// True if the edge, seen across the line, crosses the ray from the moved point towards larger
/// `major`. An end that is level with the point is below the moved one, and an edge through the
/// point is passed by the shift along `major`, against which its share of the shift along `minor`
/// does not count.
bool crosses_ray(const double* u, const double* v, const double* point, Across across) {
  const double level = point[across.minor];
  if ((u[across.minor] > level) == (v[across.minor] > level)) return false;
  if (u[across.minor] > level) std::swap(u, v);
  const double start = point[across.major];
  if (u[across.major] <= start && v[across.major] <= start) return false;
  if (u[across.major] > start && v[across.major] > start) return true;
  const auto seen = [&](const double* p) { return Point2{p[across.major], p[across.minor]}; };
  return orientation_2d(seen(u), seen(v), seen(point)) == Sign::Positive;
}

Sign normal_sign(Corners3 corner, int axis) {
  return orientation_2d(project(corner[0], axis), project(corner[1], axis),
                        project(corner[2], axis));
}

/// Returns the side of the triangle's plane on which the moved point lies. If the point lies in the
/// plane, that is the sign of n_x e + n_y e^2 + n_z e^3, which has the sign of the first n that is
/// not zero.
Sign side_of_moved(Corners3 corner, const double* point) {
  Sign side = orientation_3d(corner[0], corner[1], corner[2], point);
  for (int k = 0; k < 3 && side == Sign::Zero; ++k)
    side = normal_sign(corner, k);
  return side;
}

}  // namespace

LineCrossing cross_axis_line(const Triangle& triangle, const double* point, int axis) {
  const double* const corner[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  const Across across = kAcross[axis];
  bool is_crossing = false;
  for (int i = 0; i < 3; ++i)
    is_crossing ^= crosses_ray(corner[i], corner[(i + 1) % 3], point, across);
  if (!is_crossing) return LineCrossing::None;

  const auto [low, high] = std::minmax({corner[0][axis], corner[1][axis], corner[2][axis]});
  if (low > point[axis]) return LineCrossing::Above;
  if (high <= point[axis]) return LineCrossing::Below;
  // The moved line goes through the inside of the projection, which has an area then: neither sign
  // is zero.
  return side_of_moved(corner, point) == normal_sign(corner, axis) ? LineCrossing::Below
                                                                   : LineCrossing::Above;
}

}  // namespace graze::narrowphase
