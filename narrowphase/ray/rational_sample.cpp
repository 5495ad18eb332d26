// The sides are those of face_sample.cpp: each the sign of the first coefficient of a polynomial in
// e that is not zero.

#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/ray/rational_sample.h>
#include <graze/narrowphase/ray/sample_steps.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace graze::narrowphase {
namespace {

using Integer = GrowingInteger;

/// Holds the highest 53 bits of a number that is not negative: it is at least bits * 2^exponent,
/// and less than (bits + 1) * 2^exponent.
struct LeadingBits {
  explicit LeadingBits(const Integer& number)
      : exponent(std::max(number.bit_length() - 53, 0)),
        bits(number.shifted_down(exponent).to_double()) {}

  int exponent;
  double bits;
};

/// Returns two doubles that |number| / weight * 2^unit is between. A quotient of two integers below
/// 2^53 + 1 is rounded once, and may be rounded again where it is denormal.
std::pair<double, double> bounds_of_size(const Integer& size, const Integer& weight, int unit) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const LeadingBits top(size), bottom(weight);
  const auto outward = [&](double quotient, double towards) {
    const double scaled =
        std::ldexp(std::nextafter(quotient, towards), top.exponent - bottom.exponent + unit);
    return std::nextafter(scaled, towards);
  };
  const double low = outward(top.bits / (bottom.bits + 1), -kInfinity);
  const double high = outward((top.bits + 1) / bottom.bits, kInfinity);
  return {std::max(low, 0.0), std::min(high, std::numeric_limits<double>::max())};
}

/// Finds the signs, counted in one unit.
class SampleSides {
 public:
  SampleSides(SampleCorners corners, const RationalSample& sample)
      : sample_(sample), corners_(corners) {
    CommonUnit unit({0.0});
    for (const double* corner : corners)
      unit.include(corner, 3);
    unit_ = std::min(unit.exponent(), sample.point.unit);
    for (std::size_t k = 0; k < 3; ++k)
      at_[k] = sample.point.at[k].shifted(sample.point.unit - unit_);
  }

  /// Returns the side of an edge: zero only for one that is seen as a point.
  Sign of_edge(const double* u, const double* v, int axis) const {
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    const Step edge{u, v};
    Sign sign = (along(u, v, x) * from(u, y) - along(u, v, y) * from(u, x)).sign();
    if (sign == Sign::Zero)
      sign =
          product(sample_.side, sign_of_cross_products(unit_step(axis), edge, first(), second()));
    return sign == Sign::Zero ? last_side_of_edge(edge, axis) : sign;
  }

  /// Returns the side of the plane of a triangle with area; it is never zero.
  Sign of_plane() const {
    const double *a = corners_[0], *b = corners_[1], *c = corners_[2];
    Integer sum;
    for (int k = 0; k < 3; ++k) {
      const int x = (k + 1) % 3, y = (k + 2) % 3;
      const Integer normal = along(a, b, x) * along(a, c, y) - along(a, b, y) * along(a, c, x);
      sum = sum + normal * from(a, k);
    }
    Sign sign = sum.sign();
    if (sign == Sign::Zero)
      sign = product(sample_.side, sign_of_cross_products({a, b}, {a, c}, first(), second()));
    return sign == Sign::Zero ? last_side_of_plane(corners_) : sign;
  }

 private:
  Step first() const { return {sample_.triangle.a.data(), sample_.triangle.b.data()}; }
  Step second() const { return {sample_.triangle.a.data(), sample_.triangle.c.data()}; }

  Integer of(double value) const { return Integer::from_double(value, unit_); }
  Integer along(const double* u, const double* v, int k) const { return of(v[k]) - of(u[k]); }
  /// Returns the vector from a corner to the point, times the point's weight.
  Integer from(const double* u, int k) const {
    return at_[static_cast<std::size_t>(k)] - sample_.point.weight * of(u[k]);
  }

  const RationalSample& sample_;
  SampleCorners corners_;
  int unit_;
  std::array<Integer, 3> at_;
};

/// True if the shadow of the triangle along the axis may hold that of the point.
bool is_beside(SampleCorners corners, const Aabb& around, int axis) {
  for (const int k : {(axis + 1) % 3, (axis + 2) % 3}) {
    const auto [low, high] = std::minmax({corners[0][k], corners[1][k], corners[2][k]});
    if (low > around.max.data()[k] || high < around.min.data()[k]) return true;
  }
  return false;
}

}  // namespace

Aabb box_around(const RationalPoint& point) {
  Aabb box;
  for (int k = 0; k < 3; ++k) {
    const Integer& at = point.at[static_cast<std::size_t>(k)];
    const bool is_negative = at.sign() == Sign::Negative;
    const auto [low, high] = bounds_of_size(is_negative ? -at : at, point.weight, point.unit);
    box.min.data()[k] = is_negative ? -high : low;
    box.max.data()[k] = is_negative ? -low : high;
  }
  return box;
}

LineCrossing cross_axis_line(const Triangle& triangle, const RationalSample& sample, int axis) {
  const double* const corner[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  if (is_beside(corner, sample.around, axis)) return LineCrossing::None;
  const SampleSides sides(corner, sample);
  return crossing_by_sides(
      corner, axis, [&](const double* u, const double* v) { return sides.of_edge(u, v, axis); },
      [&] { return sides.of_plane(); });
}

}  // namespace graze::narrowphase
