#include <graze/narrowphase/exact_vector.h>
#include <graze/narrowphase/volumes/sphere_bound.h>
#include <graze/narrowphase/volumes/sphere_distance.h>
#include <algorithm>

namespace graze::narrowphase {

std::array<double, 3> nearest_point(const Aabb& box, const double* point) {
  std::array<double, 3> nearest;
  for (int i = 0; i < 3; ++i)
    nearest[i] = std::clamp(point[i], box.min.data()[i], box.max.data()[i]);
  return nearest;
}

std::optional<Sign> sign_of_reach(const double* way, double radius) {
  const double distance2 = (way[0] * way[0] + way[1] * way[1]) + way[2] * way[2];
  const double radius2 = radius * radius;
  const double bound = kSquareBound * (distance2 + radius2) + kSquareUnderflow;
  const double gap = distance2 - radius2;
  if (gap > bound) return Sign::Positive;
  if (gap < -bound) return Sign::Negative;
  return std::nullopt;
}

std::optional<Sign> sign_of_distance(const double* from, const double* to, double radius) {
  const double way[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  return sign_of_reach(way, radius);
}

std::optional<Sign> sign_of_distance(const double* from, const double* to, double radius_a,
                                     double radius_b) {
  return sign_of_distance(from, to, radius_a + radius_b);
}

Sign sign_of_distance_exact(const double* from, const double* to, double radius) {
  return sign_of_distance_exact(from, to, radius, 0);
}

Sign sign_of_distance_exact(const double* from, const double* to, double radius_a,
                            double radius_b) {
  const CommonUnit unit({from[0], from[1], from[2], to[0], to[1], to[2], radius_a, radius_b});
  const BigVector way = BigVector::difference(to, from, unit);
  return (squared(way) - squared(unit.sum(radius_a, radius_b))).sign();
}

}  // namespace graze::narrowphase
