// Forward error bounds. Below, u = 2^-53 is the unit roundoff and n = 2^-1074 the smallest double;
// an operation returns its exact result times (1 + d), |d| <= u, and a product that underflows is
// off by at most n / 2 besides. Sums and differences are exact when they underflow.

#include <graze/narrowphase/predicates/orientation_stages.h>
#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;

// Products between these neither overflow in a sum of a few of them nor leave an underflow of n
// visible beside u times their size: u * 2^-1000 = 2^-1053 is 2^21 times n.
constexpr double kSmallest = 0x1p-1000;
constexpr double kLargest = 0x1p+1000;

// Each of the two products carries three roundings (two differences, one product), and the final
// difference one more: at most (1 + u)^4 - 1 < 4.0001 u of their computed sizes' sum. The sum, its
// product with the constant, and two underflows of n / 2 fit into the last 0.99 u.
constexpr double kBound2d = 5 * kUnitRoundoff;

// Each of the six monomials of the determinant carries eight roundings: three differences, two
// products, the inner difference and two sums: (1 + u)^8 - 1 < 8.0001 u. A monomial is at most
// X Y Z, the largest differences in each coordinate, whose computed values are off by (1 + u)^3 and
// their product by (1 + u)^2 more: 6 * 8.0001 u (1 + 6 u) X Y Z < 48.01 u X Y Z. Underflow adds at
// most 3 n X + 1.5 n, which for Y Z >= 2^-1000 and X Y Z >= 2^-1000 is below 2^-18 u X Y Z.
constexpr double kBound3d = 49 * kUnitRoundoff;

double largest(double a, double b, double c) {
  return std::max(std::abs(a), std::max(std::abs(b), std::abs(c)));
}

}  // namespace

std::optional<Sign> orientation_2d_filter(Point2 a, Point2 b, Point2 c) {
  const double abx = b.x - a.x;
  const double aby = b.y - a.y;
  const double acx = c.x - a.x;
  const double acy = c.y - a.y;
  // A rounded difference is zero only if the exact one is, so these zeros are exact.
  if ((abx == 0 || acy == 0) && (aby == 0 || acx == 0)) return Sign::Zero;
  const double left = abx * acy;
  const double right = aby * acx;
  const double size = std::abs(left) + std::abs(right);
  const double area = left - right;
  if (!(size >= kSmallest && size <= kLargest)) return std::nullopt;
  if (area > kBound2d * size) return Sign::Positive;
  if (area < -kBound2d * size) return Sign::Negative;
  return std::nullopt;
}

std::optional<Sign> orientation_3d_filter(const double* a, const double* b, const double* c,
                                          const double* d) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double x = largest(bx, cx, dx);
  const double y = largest(by, cy, dy);
  const double z = largest(bz, cz, dz);
  if (x == 0 || y == 0 || z == 0) return Sign::Zero;  // all four in one axis-aligned plane, exactly
  const double yz = y * z;
  const double xyz = x * yz;
  // Together these keep every intermediate result in range.
  if (!(yz >= kSmallest && yz <= kLargest && xyz >= kSmallest && xyz <= kLargest)) {
    return std::nullopt;
  }
  const double volume =
      bx * (cy * dz - cz * dy) + cx * (dy * bz - dz * by) + dx * (by * cz - bz * cy);
  if (volume > kBound3d * xyz) return Sign::Positive;
  if (volume < -kBound3d * xyz) return Sign::Negative;
  return std::nullopt;
}

}  // namespace graze::narrowphase
