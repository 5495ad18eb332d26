#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/value/checks.h>
#include <cmath>
#include <string>

namespace graze {

namespace bvh {

double check_box(const Obb& box, const char* what) {
  const double deviation = bvh::check_rigid(box.pose, what);
  for (int i = 0; i < 3; ++i) {
    const double half = box.half_extents.data()[i];
    if (!(half >= 0) || !std::isfinite(half)) {
      throw InputError(std::string(what) + ": half extent " + "xyz"[i] +
                       " is negative or not finite");
    }
  }
  return deviation;
}

}  // namespace bvh

void check_box(const Obb& box, const char* what) {
  bvh::in_standard_arithmetic([&] { bvh::check_box(box, what); });
}

}  // namespace graze
