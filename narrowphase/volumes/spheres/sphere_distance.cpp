#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/volumes/spheres/sphere_distance.h>
#include <algorithm>

namespace graze::narrowphase {

std::array<double, 3> nearest_point(const Aabb& box, const double* point) {
  std::array<double, 3> nearest;
  for (int i = 0; i < 3; ++i)
    nearest[i] = std::clamp(point[i], box.min.data()[i], box.max.data()[i]);
  return nearest;
}

Sign sign_of_distance_exact(const double* from, const double* to, double radius) {
  return sign_of_distance_exact(from, to, radius, 0);
}

Sign sign_of_distance_exact(const double* from, const double* to, double radius_a,
                            double radius_b) {
  const CommonUnit unit({from[0], from[1], from[2], to[0], to[1], to[2], radius_a, radius_b});
  const BigVector offset = BigVector::difference(to, from, unit);
  return (squared(offset) - squared(unit.sum(radius_a, radius_b))).sign();
}

}  // namespace graze::narrowphase
