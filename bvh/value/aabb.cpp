#include <graze/bvh/aabb.h>
#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <cmath>
#include <string>

namespace graze {

namespace bvh {

void check_box(const Aabb& box, const char* what) {
  for (int i = 0; i < 3; ++i) {
    const double low = box.min.data()[i];
    const double high = box.max.data()[i];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      throw InputError(std::string(what) + ": coordinate " + "xyz"[i] + " is not finite");
    }
    if (low > high) {
      throw InputError(std::string(what) + ": minimum exceeds maximum in coordinate " + "xyz"[i]);
    }
  }
}

}  // namespace bvh

void check_box(const Aabb& box, const char* what) {
  bvh::in_standard_arithmetic([&] { bvh::check_box(box, what); });
}

}  // namespace graze
