#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/spheres/sphere_distance.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <cmath>
#include <string>

namespace graze {
namespace narrowphase {

Decision decide(const Sphere& sphere_a, const Sphere& sphere_b) {
  const double* a = sphere_a.centre.data();
  const double* b = sphere_b.centre.data();
  const std::optional<Sign> sure = sign_of_distance(a, b, sphere_a.radius, sphere_b.radius);
  if (sure) return {*sure == Sign::Negative, Stage::Triage};
  return {overlap_exactly(sphere_a, sphere_b), Stage::Exact};
}

bool overlap_exactly(const Sphere& sphere_a, const Sphere& sphere_b) {
  return sign_of_distance_exact(sphere_a.centre.data(), sphere_b.centre.data(), sphere_a.radius,
                                sphere_b.radius) != Sign::Positive;
}

Decision decide_contains(const Sphere& sphere, const Eigen::Vector3d& point) {
  const double* centre = sphere.centre.data();
  const std::optional<Sign> sure = sign_of_distance(centre, point.data(), sphere.radius);
  if (sure) return {*sure == Sign::Negative, Stage::Triage};
  const Sign sign = sign_of_distance_exact(centre, point.data(), sphere.radius);
  return {sign != Sign::Positive, Stage::Exact};
}

}  // namespace narrowphase

bool intersects(const Sphere& sphere_a, const Sphere& sphere_b) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_sphere(sphere_a, "sphere a");
    bvh::check_sphere(sphere_b, "sphere b");
    return narrowphase::decide(sphere_a, sphere_b).is_hit;
  });
}

bool contains(const Sphere& sphere, const Eigen::Vector3d& point) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_sphere(sphere, "sphere");
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(point.data()[i])) {
        throw InputError(std::string("point: coordinate ") + "xyz"[i] + " is not finite");
      }
    }
    return narrowphase::decide_contains(sphere, point).is_hit;
  });
}

}  // namespace graze
