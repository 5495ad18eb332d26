#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/ray.h>

#include <cmath>
#include <string>

namespace graze {

void check_ray(const Ray& ray, const char* what) {
  bvh::in_standard_arithmetic([&] {
    bool is_zero = true;
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(ray.origin.data()[k])) {
        throw InputError(std::string(what) + ": coordinate " + "xyz"[k] +
                         " of the origin is not finite");
      }
      if (!std::isfinite(ray.direction.data()[k])) {
        throw InputError(std::string(what) + ": component " + "xyz"[k] +
                         " of the direction is not finite");
      }
      is_zero &= ray.direction.data()[k] == 0;
    }
    if (is_zero) throw InputError(std::string(what) + ": the direction is zero");
    if (!(ray.max_distance >= 0)) {
      throw InputError(std::string(what) + ": the largest distance is negative or not a number");
    }
  });
}

}  // namespace graze
