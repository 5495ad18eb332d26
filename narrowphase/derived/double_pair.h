#pragma once

// This file holds numbers of twice the precision of double, as unevaluated sums of two. Joldes,
// Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic", ACM Transactions on Mathematical Software 44(2), 2017: AccurateDWPlusDW is off by 3
// u^2 (1 + 5 u), DWTimesDW1 by 7 u^2, relative to the result, u = 2^-53, while nothing overflows
// and no error term underflows, which the caller makes sure of.

#include <graze/narrowphase/predicates/big_integer.h>
#include <graze/narrowphase/predicates/expansion.h>
#include <cmath>

namespace graze::narrowphase {

/// A bound of what one sum, product or quotient below is off by, relative to its result.
inline constexpr double kPairRoundoff = 0x1p-101;

struct DoublePair {
  double high;
  double low;
};

/// Returns Dekker's sum of a and a b that is no larger.
inline DoublePair ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a - b, exactly.
inline DoublePair exact_difference(double a, double b) {
  const RoundedPair pair = two_sum(a, -b);
  return {pair.value, pair.error};
}

inline DoublePair operator-(const DoublePair& a) {
  return {-a.high, -a.low};
}

inline DoublePair operator+(const DoublePair& a, const DoublePair& b) {
  const RoundedPair high = two_sum(a.high, b.high);
  const RoundedPair low = two_sum(a.low, b.low);
  const DoublePair sum = ordered_sum(high.value, high.error + low.value);
  return ordered_sum(sum.high, low.error + sum.low);
}

inline DoublePair operator-(const DoublePair& a, const DoublePair& b) {
  return a + -b;
}

inline DoublePair operator*(const DoublePair& a, const DoublePair& b) {
  const RoundedPair product = two_product(a.high, b.high);
  return ordered_sum(product.value, product.error + (a.high * b.low + a.low * b.high));
}

inline DoublePair operator*(const DoublePair& a, double b) {
  const RoundedPair product = two_product(a.high, b);
  return ordered_sum(product.value, product.error + a.low * b);
}

/// Divides in two steps of long division. The first remainder is off by less than 11 u^2 of a, from
/// its product and its difference; the second quotient by 2 u of a remainder that is 4 u of a.
inline DoublePair operator/(const DoublePair& a, const DoublePair& b) {
  const double first = a.high / b.high;
  const DoublePair remainder = a - b * first;
  return ordered_sum(first, remainder.high / b.high);
}

/// Returns the square root of a positive number, rounded: off by half an ulp and a little.
inline double rounded_root(const DoublePair& square) {
  const double root = std::sqrt(square.high);
  const RoundedPair again = two_product(root, root);
  const double remainder = ((square.high - again.value) - again.error) + square.low;
  return root + remainder / (2 * root);
}

/// Returns base + offset, off by half an ulp and a little.
inline double rounded_sum(double base, const DoublePair& offset) {
  const RoundedPair sum = two_sum(base, offset.high);
  return sum.value + (sum.error + offset.low);
}

struct PairVector {
  DoublePair x;
  DoublePair y;
  DoublePair z;

  /// a - b for arrays of three doubles, exactly.
  static PairVector difference(const double* a, const double* b) {
    return {exact_difference(a[0], b[0]), exact_difference(a[1], b[1]),
            exact_difference(a[2], b[2])};
  }
};

inline DoublePair dot(const PairVector& a, const PairVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline PairVector cross(const PairVector& a, const PairVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline PairVector operator-(const PairVector& a, const PairVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline PairVector operator+(const PairVector& a, const PairVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline PairVector operator*(const PairVector& a, const DoublePair& b) {
  return {a.x * b, a.y * b, a.z * b};
}

inline double largest_component(const PairVector& a) {
  return std::fmax(std::abs(a.x.high), std::fmax(std::abs(a.y.high), std::abs(a.z.high)));
}

// The functions below take integers back to doubles, with one rounding. `exponent` scales by a
// power of two.

/// numerator / denominator * 2^exponent, off by at most 0.51 ulp; infinite if it overflows. The
/// denominator is positive.
double rounded_ratio(const BigInteger& numerator, const BigInteger& denominator, int exponent);

/// The square root of numerator / denominator, times 2^exponent, off by as little; both are
/// positive.
double rounded_root_of_ratio(const BigInteger& numerator, const BigInteger& denominator,
                             int exponent);

}  // namespace graze::narrowphase
