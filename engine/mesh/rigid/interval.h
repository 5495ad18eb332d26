#pragma once

// This is private to engine/mesh/rigid.

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

/// All numbers from low to high, among which is what is computed in real arithmetic. Each bound is
/// rounded to nearest and then moved by 2^-52 of it, at least to the next double, and by the
/// smallest there is. Numbers must not overflow.
struct Interval {
  double low;
  double high;

  Interval(double exact) : low(exact), high(exact) {}  // NOLINT(google-explicit-constructor)
  Interval(double from, double to) : low(from), high(to) {}

  static Interval outward(double from, double to) {
    constexpr double kStep = 0x1p-52, kSmallest = std::numeric_limits<double>::denorm_min();
    return {from - (std::abs(from) * kStep + kSmallest), to + (std::abs(to) * kStep + kSmallest)};
  }

  friend Interval operator+(const Interval& a, const Interval& b) {
    return outward(a.low + b.low, a.high + b.high);
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return outward(a.low - b.high, a.high - b.low);
  }
  friend Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
  friend Interval operator*(const Interval& a, const Interval& b) {
    const double products[4] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    const double least =
        std::min(std::min(products[0], products[1]), std::min(products[2], products[3]));
    const double most =
        std::max(std::max(products[0], products[1]), std::max(products[2], products[3]));
    return outward(least, most);
  }
};

/// Returns the reciprocal of what is surely above 0.
inline Interval reciprocal(const Interval& a) {
  return Interval::outward(1 / a.high, 1 / a.low);
}

/// Returns the root of what is not negative: a low bound below 0 is rounding.
inline Interval root(const Interval& a) {
  return Interval::outward(std::sqrt(std::max(a.low, 0.0)), std::sqrt(a.high));
}

}  // namespace graze
