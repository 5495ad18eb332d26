#pragma once

// This file holds polynomials in time of any degree, with integer coefficients of any length: what
// clearances need (near_contact.cpp), and what is too long for polynomial.h.

#include <graze/narrowphase/predicates/growing_integer.h>

#include <vector>

namespace graze::narrowphase {

/// A polynomial with the coefficient of t^i at place i; the last one is not zero. The zero
/// polynomial has none.
class LongPolynomial {
 public:
  LongPolynomial() = default;
  explicit LongPolynomial(std::vector<GrowingInteger> coefficients);

  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  bool is_zero() const { return coefficients_.empty(); }
  const GrowingInteger& operator[](int i) const {
    return coefficients_[static_cast<std::size_t>(i)];
  }
  const GrowingInteger& leading() const { return coefficients_.back(); }
  Sign sign_at_start() const { return is_zero() ? Sign::Zero : coefficients_[0].sign(); }

 private:
  std::vector<GrowingInteger> coefficients_;
};

LongPolynomial operator+(const LongPolynomial& f, const LongPolynomial& g);
LongPolynomial operator-(const LongPolynomial& f, const LongPolynomial& g);
LongPolynomial operator*(const LongPolynomial& f, const LongPolynomial& g);
LongPolynomial derivative(const LongPolynomial& f);

/// Returns the greatest common divisor of f and g, times some number; neither is zero. It is found
/// by subresultants (Knuth, The Art of Computer Programming 2, 4.6.1, algorithm C), whose
/// coefficients grow as slowly as determinants.
LongPolynomial greatest_common_divisor(const LongPolynomial& f, const LongPolynomial& g);

/// Returns f without its multiple roots, which become simple, times some number; f is not zero.
LongPolynomial square_free(const LongPolynomial& f);

/// The number numerator / 2^bits.
struct LongDyadic {
  GrowingInteger numerator;
  int bits = 0;
};

Sign sign_at(const LongPolynomial& f, const LongDyadic& t);

/// Returns f in Bernstein's basis from `from` to `from` + 2^-bits, times something positive.
std::vector<GrowingInteger> bernstein(const LongPolynomial& f, const LongDyadic& from);

}  // namespace graze::narrowphase
