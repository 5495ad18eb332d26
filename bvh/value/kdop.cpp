#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/value/checks.h>
#include <cmath>
#include <string>

namespace graze {

namespace bvh {

void check_kdop(const KDop<18>& kdop, const char* what) {
  for (int i = 0; i < KDop<18>::kSlabs; ++i) {
    if (!std::isfinite(kdop.min[i]) || !std::isfinite(kdop.max[i])) {
      throw InputError(std::string(what) + ": slab " + std::to_string(i) + " is not finite",
                       {.element = "slab", .index = static_cast<std::size_t>(i)});
    }
    if (kdop.min[i] > kdop.max[i]) {
      throw InputError(std::string(what) + ": minimum exceeds maximum in slab " + std::to_string(i),
                       {.element = "slab", .index = static_cast<std::size_t>(i)});
    }
  }
}

}  // namespace bvh

void check_kdop(const KDop<18>& kdop, const char* what) {
  bvh::in_standard_arithmetic([&] { bvh::check_kdop(kdop, what); });
}

}  // namespace graze
