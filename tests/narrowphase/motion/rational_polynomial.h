#pragma once

// Polynomials with rational coefficients: Sturm's sequences. Slow, and apart from the library's
// ways: no Bernstein coefficients, no discriminants, no bounds.

#include <gmpxx.h>

#include <vector>

namespace graze::oracle {

/// The coefficient of t^i at place i; no zeros at the end.
using RationalPolynomial = std::vector<mpq_class>;

RationalPolynomial operator+(const RationalPolynomial& f, const RationalPolynomial& g);
RationalPolynomial operator-(const RationalPolynomial& f, const RationalPolynomial& g);
RationalPolynomial operator*(const RationalPolynomial& f, const RationalPolynomial& g);

/// Times a positive number, so that the coefficients are integers without a common factor.
RationalPolynomial in_integers(RationalPolynomial f);

/// Of a polynomial in integers.
int sign_of_value(const RationalPolynomial& f, const mpq_class& t);

/// f without its multiple roots, which become simple; not zero.
RationalPolynomial square_free(const RationalPolynomial& f);

/// A root of a polynomial without multiple roots: the only one in (low, high), whose ends are none;
/// or `low` itself where both are the same.
struct RationalRoot {
  const RationalPolynomial* f;
  mpq_class low;
  mpq_class high;

  /// Halves the stretch.
  void refine();
};

/// All roots in [0, 1] of a polynomial without multiple roots, which must outlive them.
std::vector<RationalRoot> roots_of(const RationalPolynomial& f);

/// The roots in [0, 1] of polynomials that are not zero and have no multiple roots, which must
/// outlive them, in their order, each once.
std::vector<RationalRoot> all_roots(const std::vector<RationalPolynomial>& polynomials);

/// The order of two roots: -1, 0 or 1. Their stretches are apart afterwards, or they are equal.
int compare(RationalRoot& a, RationalRoot& b);

/// The sign of g at a root.
int sign_at(const RationalPolynomial& g, const RationalRoot& root);

/// The largest double that is not above a root.
double rounded_down(const RationalRoot& root);

}  // namespace graze::oracle
