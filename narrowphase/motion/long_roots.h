#pragma once

// The real roots of a LongPolynomial in (0, 1], each exactly, and signs there.

#include <graze/narrowphase/motion/long_polynomial.h>

#include <utility>
#include <vector>

namespace graze::narrowphase {

/// A root that stands alone, and is simple, in the open stretch from `low` to `low` + 2^-bits; or
/// that is `low` itself.
class LongRoot {
 public:
  /// Of f, which must outlive it, and whose coefficients in Bernstein's basis these are.
  LongRoot(const LongPolynomial& f, const LongDyadic& low, std::vector<GrowingInteger> bernstein)
      : f_(&f), low_(low), bernstein_(std::move(bernstein)) {}
  LongRoot(const LongPolynomial& f, const LongDyadic& place)
      : f_(&f), low_(place), is_dyadic_(true) {}

  /// The largest double that is not above it.
  double rounded_down();

  /// The sign of g there.
  Sign sign_of(const LongPolynomial& g);
  /// And just before: its own, or that of the first derivative that is not zero.
  Sign sign_before(const LongPolynomial& g);

 private:
  void refine();

  const LongPolynomial* f_;
  LongDyadic low_;
  std::vector<GrowingInteger> bernstein_;
  bool is_dyadic_ = false;
};

/// The roots of f, which is not zero, in (0, 1], first to last. `simple` becomes what has them all
/// and none of them twice, where that is not f itself; both must outlive them. By the rule of
/// Descartes, as in roots.h.
std::vector<LongRoot> long_roots_of(const LongPolynomial& f, LongPolynomial& simple);

}  // namespace graze::narrowphase
