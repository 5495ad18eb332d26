#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/ray.h>

#include <cmath>
#include <string>

namespace graze {

namespace {

[[noreturn]] void refuse(const Ray& ray, const char* what) {
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(ray.origin.data()[k])) {
      throw InputError(std::string(what) + ": coordinate " + "xyz"[k] +
                       " of the origin is not finite");
    }
    if (!std::isfinite(ray.direction.data()[k])) {
      throw InputError(std::string(what) + ": component " + "xyz"[k] +
                       " of the direction is not finite");
    }
  }
  const double* d = ray.direction.data();
  if (d[0] == 0 && d[1] == 0 && d[2] == 0)
    throw InputError(std::string(what) + ": the direction is zero");
  throw InputError(std::string(what) + ": the largest distance is negative or not a number");
}

}  // namespace

void check_ray(const Ray& ray, const char* what) {
  bvh::in_standard_arithmetic([&] {
    const double* o = ray.origin.data();
    const double* d = ray.direction.data();
    // x - x is 0, or not a number where x is not finite.
    const double zero = ((o[0] - o[0]) + (o[1] - o[1]) + (o[2] - o[2])) +
                        ((d[0] - d[0]) + (d[1] - d[1]) + (d[2] - d[2]));
    const bool has_direction = d[0] != 0 || d[1] != 0 || d[2] != 0;
    if (!(zero == 0 && has_direction && ray.max_distance >= 0)) refuse(ray, what);
  });
}

}  // namespace graze
