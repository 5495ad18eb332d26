#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/sphere.h>
#include <graze/bvh/value/checks.h>
#include <cmath>
#include <string>

namespace graze {

namespace bvh {

void check_sphere(const Sphere& sphere, const char* what) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(sphere.centre.data()[i])) {
      throw InputError(std::string(what) + ": coordinate " + "xyz"[i] +
                       " of the centre is not finite");
    }
  }
  if (!(sphere.radius >= 0) || !std::isfinite(sphere.radius)) {
    throw InputError(std::string(what) + ": the radius is negative or not finite");
  }
}

}  // namespace bvh

void check_sphere(const Sphere& sphere, const char* what) {
  bvh::in_standard_arithmetic([&] { bvh::check_sphere(sphere, what); });
}

}  // namespace graze
