#pragma once

// Finds the real roots of a LongPolynomial in (0, 1], each exactly, and signs there.

#include <graze/narrowphase/motion/long_polynomial.h>

#include <utility>
#include <vector>

namespace graze::narrowphase {

/// A root that stands alone, and is simple, in the open stretch from `low` to `low` + 2^-bits; or
/// that is `low` itself.
class LongRoot {
 public:
  /// Takes a root of f, which must outlive it, and the coefficients of f in Bernstein's basis on
  /// the stretch.
  LongRoot(const LongPolynomial& f, const LongDyadic& low, std::vector<GrowingInteger> bernstein)
      : f_(&f), low_(low), bernstein_(std::move(bernstein)) {}
  LongRoot(const LongPolynomial& f, const LongDyadic& place)
      : f_(&f), low_(place), is_dyadic_(true) {}

  /// Returns the largest double that is not above the root.
  double rounded_down();

  /// Returns the sign of g at the root.
  Sign sign_of(const LongPolynomial& g);
  /// Returns the sign of g just before the root: its own there, or that of the first derivative
  /// that is not zero.
  Sign sign_before(const LongPolynomial& g);

 private:
  void refine();

  const LongPolynomial* f_;
  LongDyadic low_;
  std::vector<GrowingInteger> bernstein_;
  bool is_dyadic_ = false;
};

/// Returns the roots of f, which is not zero, in (0, 1], first to last. Where f has multiple roots
/// `simple` becomes the polynomial that has all of them once; both must outlive the roots. They are
/// found by the rule of Descartes, as in roots.h.
std::vector<LongRoot> long_roots_of(const LongPolynomial& f, LongPolynomial& simple);

}  // namespace graze::narrowphase
