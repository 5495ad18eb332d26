// This file holds the stages of the orientation predicates, one after the other: rounded with a
// bound, expansions, integers of any size; and, at the end, who asks them in which order. A fan of
// edges has the rounded stage alone.
//
// Forward error bounds. Below, u = 2^-53 is the unit roundoff and n = 2^-1074 the smallest double;
// an operation returns its exact result times (1 + d), |d| <= u, and a product that underflows is
// off by at most n / 2 besides. Sums and differences are exact when they underflow.

#include <graze/bvh/error.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/predicates/expansion.h>
#include <graze/narrowphase/predicates/orientation_stages.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

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

// Two determinants are computed at once, in a register of any CPU.
using Both = double __attribute__((vector_size(16)));
using BothSigns = std::int64_t __attribute__((vector_size(16)));

/// Returns the absolute values.
inline Both absolute(Both v) {
  return reinterpret_cast<Both>(reinterpret_cast<BothSigns>(v) &
                                std::numeric_limits<std::int64_t>::max());
}

/// Answers as orientation_2d_filter() does, in vectors and without its zeros: 1 or -1 where that is
/// sure, else 0.
inline BothSigns sure_signs(Both ux, Both uy, Both vx, Both vy) {
  const Both both_left = ux * vy, both_right = uy * vx;
  const Both sizes = absolute(both_left) + absolute(both_right);
  const Both areas = both_left - both_right;
  const BothSigns is_in_range = (sizes >= kSmallest) & (sizes <= kLargest);
  // A comparison that is true is -1.
  return is_in_range & ((areas < -kBound2d * sizes) - (areas > kBound2d * sizes));
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

FanSides fan_filter(Point2 vertex, Point2 a, Point2 b, Point2 c, Point2 d) {
  const Both c_d_x = Both{c.x, d.x} - vertex.x, c_d_y = Both{c.y, d.y} - vertex.y;
  const Both a_b_x = Both{a.x, b.x} - vertex.x, a_b_y = Both{a.y, b.y} - vertex.y;
  const Both b_d_x{a_b_x[1], c_d_x[1]}, b_d_y{a_b_y[1], c_d_y[1]};
  const Both a_c_x{a_b_x[0], c_d_x[0]}, a_c_y{a_b_y[0], c_d_y[0]};
  const BothSigns own = sure_signs(a_c_x, a_c_y, b_d_x, b_d_y);
  const BothSigns of_a =
      sure_signs(Both{a_b_x[0], a_b_x[0]}, Both{a_b_y[0], a_b_y[0]}, c_d_x, c_d_y);
  const BothSigns of_b =
      sure_signs(Both{a_b_x[1], a_b_x[1]}, Both{a_b_y[1], a_b_y[1]}, c_d_x, c_d_y);
  const auto sign = [](std::int64_t of) { return static_cast<int>(of); };
  return {sign(own[0]), sign(own[1]), sign(of_a[0]), sign(of_a[1]), sign(of_b[0]), sign(of_b[1])};
}

std::optional<Sign> orientation_3d_filter(const double* a, const double* b, const double* c,
                                          const double* d) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double x = largest(bx, cx, dx);
  const double y = largest(by, cy, dy);
  const double z = largest(bz, cz, dz);
  if (x == 0 || y == 0 || z == 0)
    return Sign::Zero;  // then all four are in one axis-aligned
                        // plane, exactly
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

namespace {

// Expansions are exact while every coordinate is zero, or has an absolute value between these. A
// difference is then a multiple of 2^(-290 - 52), so that a product of three is a multiple of
// 2^-1026, far above the smallest double 2^-1074: no product underflows, nor does its error term.
// Differences are at most 2^331, a sum of six products of three below 2^996, and Veltkamp's
// splitting multiplies by less than 2^28: the products that it splits, of degree two, stay below
// 2^664. Nothing overflows.
constexpr double kSmallestCoordinate = 0x1p-290;
constexpr double kLargestCoordinate = 0x1p+330;

bool is_safe(double coordinate) {
  const double size = std::abs(coordinate);
  return size == 0 || (size >= kSmallestCoordinate && size <= kLargestCoordinate);
}

bool are_safe(const double* point) {
  return is_safe(point[0]) && is_safe(point[1]) && is_safe(point[2]);
}

bool are_safe(Point2 point) {
  return is_safe(point.x) && is_safe(point.y);
}

Expansion<2> difference(double a, double b) {
  return Expansion<2>::difference(a, b);
}

/// Returns the sign of (b - a) x (c - a), with differences taken exactly by `minus`.
template <typename Difference>
Sign sign_of_area(Point2 a, Point2 b, Point2 c, const Difference& minus) {
  return (minus(b.x, a.x) * minus(c.y, a.y) - minus(b.y, a.y) * minus(c.x, a.x)).sign();
}

/// Returns the sign of ((b - a) x (c - a)) . (d - a), with such differences.
template <typename Difference>
Sign sign_of_volume(const double* a, const double* b, const double* c, const double* d,
                    const Difference& minus) {
  const auto bx = minus(b[0], a[0]), by = minus(b[1], a[1]), bz = minus(b[2], a[2]);
  const auto cx = minus(c[0], a[0]), cy = minus(c[1], a[1]), cz = minus(c[2], a[2]);
  const auto dx = minus(d[0], a[0]), dy = minus(d[1], a[1]), dz = minus(d[2], a[2]);
  return ((by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz).sign();
}

}  // namespace

std::optional<Sign> orientation_2d_expansion(Point2 a, Point2 b, Point2 c) {
  if (!are_safe(a) || !are_safe(b) || !are_safe(c)) return std::nullopt;
  return sign_of_area(a, b, c, difference);
}

std::optional<Sign> orientation_3d_expansion(const double* a, const double* b, const double* c,
                                             const double* d) {
  if (!are_safe(a) || !are_safe(b) || !are_safe(c) || !are_safe(d)) return std::nullopt;
  return sign_of_volume(a, b, c, d, difference);
}

Sign orientation_2d_big(Point2 a, Point2 b, Point2 c) {
  return sign_of_area(a, b, c, CommonUnit({a.x, a.y, b.x, b.y, c.x, c.y}));
}

Sign orientation_3d_big(const double* a, const double* b, const double* c, const double* d) {
  const CommonUnit minus({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2]});
  return sign_of_volume(a, b, c, d, minus);
}

void check_finite(const Triangle& triangle, const char* what) {
  const double* corners[] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(corners[i][k])) {
        throw InputError(std::string(what) + ": coordinate " + "xyz"[k] + " of vertex " + "abc"[i] +
                         " is not finite");
      }
    }
  }
}

Sign orientation_2d(Point2 a, Point2 b, Point2 c) {
  if (const auto sign = orientation_2d_filter(a, b, c)) return *sign;
  if (const auto sign = orientation_2d_expansion(a, b, c)) return *sign;
  return orientation_2d_big(a, b, c);
}

Sign orientation_3d(const double* a, const double* b, const double* c, const double* d) {
  if (const auto sign = orientation_3d_filter(a, b, c, d)) return *sign;
  if (const auto sign = orientation_3d_expansion(a, b, c, d)) return *sign;
  return orientation_3d_big(a, b, c, d);
}

}  // namespace graze::narrowphase
