#pragma once

// This file holds times as exact numbers, and signs of polynomials there.

#include <graze/narrowphase/motion/polynomial.h>
#include <bit>
#include <cmath>

namespace graze::narrowphase {

template <typename Integer>
Integer whole(double value) {
  return Integer::from_double(value, 0);
}

/// The time numerator / 2^bits; the largest double that is not above it can be asked for.
template <typename Integer>
struct Dyadic {
  Integer numerator;
  int bits = 0;
  double floor = 0;
  bool is_double = true;

  Dyadic() = default;  // zero
  explicit Dyadic(double time)
      : bits(time == 0 || time == 1 ? 0 : -exponent_of_lowest_bit(time)), floor(time) {
    numerator = Integer::from_double(time, -bits);
  }
};

/// The time numerator / denominator, which is positive.
template <typename Integer>
struct Fraction {
  Integer numerator;
  Integer denominator;

  /// Returns the root of slope t + offset; the slope is not zero.
  static Fraction root_of(const Integer& slope, const Integer& offset) {
    if (slope.sign() == Sign::Negative) return {offset, -slope};
    return {-offset, slope};
  }
};

/// Returns the sign of f(t) 2^(bits degree), by Horner's rule.
template <typename Coefficient, typename Integer>
Sign sign_at(const IntegerPolynomial<Coefficient>& f, const Dyadic<Integer>& t) {
  if (f.degree < 0) return Sign::Zero;
  Integer value(f.coefficient[f.degree]);
  for (int i = f.degree - 1; i >= 0; --i)
    value = value * t.numerator + Integer(f.coefficient[i]).shifted(t.bits * (f.degree - i));
  return value.sign();
}

template <typename Coefficient, typename Integer>
Sign sign_at(const IntegerPolynomial<Coefficient>& f, const Fraction<Integer>& t) {
  if (f.degree < 0) return Sign::Zero;
  Integer value(f.coefficient[f.degree]);
  Integer scale = t.denominator;
  for (int i = f.degree - 1; i >= 0; --i) {
    value = value * t.numerator + Integer(f.coefficient[i]) * scale;
    if (i > 0) scale = scale * t.denominator;
  }
  return value.sign();
}

/// Returns the sign of a - b.
template <typename Integer>
Sign compare(const Fraction<Integer>& a, const Dyadic<Integer>& b) {
  return (a.numerator.shifted(b.bits) - b.numerator * a.denominator).sign();
}

template <typename Integer>
Sign compare(const Fraction<Integer>& a, const Fraction<Integer>& b) {
  return (a.numerator * b.denominator - b.numerator * a.denominator).sign();
}

inline double next_double(double time) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(time) + 1);
}

inline double previous_double(double time) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(time) - 1);
}

/// Returns a double between two that are not neighbours, both at least 0. It is in the middle,
/// unless that would take long to come near 0: then it is in the middle of all doubles between.
inline double double_between(double low, double high) {
  if (high > 0x1p-6) return low + (high - low) / 2;
  const auto bits_low = std::bit_cast<std::uint64_t>(low);
  const auto bits_high = std::bit_cast<std::uint64_t>(high);
  return std::bit_cast<double>(bits_low + (bits_high - bits_low) / 2);
}

template <typename Integer>
bool are_neighbours(const Dyadic<Integer>& low, const Dyadic<Integer>& high) {
  return !low.is_double || !high.is_double || next_double(low.floor) == high.floor;
}

/// Returns a time between two: a double, if there is one.
template <typename Integer>
Dyadic<Integer> between(const Dyadic<Integer>& low, const Dyadic<Integer>& high) {
  if (!are_neighbours(low, high)) return Dyadic<Integer>(double_between(low.floor, high.floor));
  Dyadic<Integer> middle;
  const int bits = low.bits > high.bits ? low.bits : high.bits;
  middle.numerator =
      low.numerator.shifted(bits - low.bits) + high.numerator.shifted(bits - high.bits);
  middle.bits = bits + 1;
  middle.floor = low.floor;
  middle.is_double = false;
  return middle;
}

}  // namespace graze::narrowphase
