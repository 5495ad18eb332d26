#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/ray.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

namespace graze {

namespace {

constexpr std::uint64_t kInfiniteBits = std::uint64_t{0x7ff} << 52;
constexpr std::uint64_t kMinusZeroBits = std::uint64_t{1} << 63;
constexpr std::uint64_t kExponentStep = std::uint64_t{1} << 52;

/// Returns the bits of |x|, which are in the order of sizes, with NaN above infinity.
std::uint64_t bits_of_size(double x) {
  return std::bit_cast<std::uint64_t>(x) & ~kMinusZeroBits;
}

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
  // Numbers are compared by their bits, as whole numbers: every ray comes by here, and no control
  // word matters to these. What is not finite has an exponent of ones alone: one step more comes to
  // the sign's bit.
  std::uint64_t one_step_more = 0, direction = 0;
  for (int k = 0; k < 3; ++k) {
    const std::uint64_t o = bits_of_size(ray.origin.data()[k]);
    const std::uint64_t d = bits_of_size(ray.direction.data()[k]);
    one_step_more |= (o + kExponentStep) | (d + kExponentStep);
    direction |= d;
  }
  const auto most = std::bit_cast<std::uint64_t>(ray.max_distance);
  const bool is_distance = most <= kInfiniteBits || most == kMinusZeroBits;
  if ((one_step_more & kMinusZeroBits) != 0 || direction == 0 || !is_distance)
    bvh::in_standard_arithmetic([&] { refuse(ray, what); });
}

}  // namespace graze
