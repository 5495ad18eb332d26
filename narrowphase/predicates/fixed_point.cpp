#include <graze/narrowphase/predicates/fixed_point.h>
#include <algorithm>
#include <bit>
#include <cmath>

namespace graze::narrowphase {
namespace {

constexpr int kBits = 60;

// From here up, the unit and its inverse are powers of two in the range of normal doubles. Smaller
// numbers are taken larger first, which is exact for all of them.
constexpr double kSmallest = 0x1p-900;
constexpr double kEnlargement = 0x1p+200;

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Returns the exponent e of a normal number: 2^e <= value < 2^(e + 1).
int exponent_of(double value) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52) - 1023;
}

bool to_fixed_axis(const double* const* points, int count, int axis, FixedPoint* fixed) {
  double largest = 0;
  for (int i = 0; i < count; ++i)
    largest = std::max(largest, std::abs(points[i][axis]));
  if (largest == 0) {
    for (int i = 0; i < count; ++i)
      fixed[i][axis] = 0;
    return true;
  }
  const double enlargement = largest < kSmallest ? kEnlargement : 1;
  largest *= enlargement;
  const int unit = exponent_of(largest) + 1 - kBits;
  const double scale = power_of_two(-unit);
  const double inverse = power_of_two(unit);
  bool is_exact = true;
  for (int i = 0; i < count; ++i) {
    // A value that conversion and back does not restore is no integer, or underflows.
    const double value = points[i][axis] * enlargement;
    const auto integer = static_cast<std::int64_t>(value * scale);
    is_exact &= static_cast<double>(integer) * inverse == value;
    fixed[i][axis] = integer;
  }
  return is_exact;
}

}  // namespace

bool to_fixed_point(const double* const* points, int count, FixedPoint* fixed) {
  return to_fixed_axis(points, count, 0, fixed) && to_fixed_axis(points, count, 1, fixed) &&
         to_fixed_axis(points, count, 2, fixed);
}

}  // namespace graze::narrowphase
