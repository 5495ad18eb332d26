#pragma once

// This file holds differences of doubles as integers, and vectors of them, with which exact stages
// compute.

#include <graze/narrowphase/predicates/big_integer.h>
#include <initializer_list>

namespace graze::narrowphase {

/// The unit in which some finite doubles are all integers: the lowest bit among them.
class CommonUnit {
 public:
  CommonUnit(std::initializer_list<double> values);

  /// Takes `count` more values into account. It must be called before anything is counted in this
  /// unit.
  void include(const double* values, int count);

  /// Return the integers value, a - b and a + b in this unit, for values that it was made for.
  BigInteger of(double value) const { return BigInteger::from_double(value, unit_); }
  BigInteger operator()(double a, double b) const { return of(a) - of(b); }
  BigInteger sum(double a, double b) const { return of(a) + of(b); }

  /// Returns the exponent: the unit is 2^exponent().
  int exponent() const { return unit_; }

 private:
  int unit_ = 1024;
};

struct BigVector {
  BigInteger x;
  BigInteger y;
  BigInteger z;

  /// Returns a - b for arrays of three doubles.
  static BigVector difference(const double* a, const double* b, const CommonUnit& unit);
};

BigInteger dot(const BigVector& a, const BigVector& b);
BigVector cross(const BigVector& a, const BigVector& b);

inline BigInteger squared(const BigInteger& a) {
  return a * a;
}

inline BigInteger squared(const BigVector& a) {
  return dot(a, a);
}

}  // namespace graze::narrowphase
