#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/predicates/expansion.h>
#include <graze/narrowphase/predicates/orientation_stages.h>
#include <cmath>

namespace graze::narrowphase {
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

/// (b - a) x (c - a), with differences taken exactly by `minus`.
template <typename Difference>
Sign sign_of_area(Point2 a, Point2 b, Point2 c, const Difference& minus) {
  return (minus(b.x, a.x) * minus(c.y, a.y) - minus(b.y, a.y) * minus(c.x, a.x)).sign();
}

/// ((b - a) x (c - a)) . (d - a), likewise.
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

}  // namespace graze::narrowphase
