#pragma once

// This file holds polynomials in time with integer coefficients, and the differences of points on
// straight paths that they are made of.

#include <graze/narrowphase/motion/paths.h>
#include <graze/narrowphase/predicates/exact_vector.h>

#include <array>

namespace graze::narrowphase {

/// A polynomial of degree three at most. The highest coefficient is not zero; the zero polynomial
/// has degree -1.
template <typename Integer>
struct IntegerPolynomial {
  std::array<Integer, 4> coefficient;  ///< the coefficient of t^i at place i; those above the
                                       ///< degree are zero
  int degree = -1;

  /// Takes the first `count` coefficients as those of the polynomial; the highest of them may be
  /// zero.
  void take(int count) {
    degree = count - 1;
    while (degree >= 0 && coefficient[degree].is_zero())
      --degree;
  }
};

using Polynomial = IntegerPolynomial<BigInteger>;

Polynomial derivative(const Polynomial& f);

/// A number that changes steadily: start + t change.
struct LinearPath {
  BigInteger start;
  BigInteger change;
};

/// Return a b, and a b - c d.
Polynomial product(const LinearPath& a, const LinearPath& b);
Polynomial difference_of_products(const LinearPath& a, const LinearPath& b, const LinearPath& c,
                                  const LinearPath& d);

/// Holds four paths in units in which all their coordinates are integers. Each axis has a unit of
/// its own: what is asked is whether hulls share a point, which scaling an axis does not change.
///
/// A coordinate has at most 2098 bits (BigInteger), the offset of two 2099, its change 2100. A
/// component of a cross product has products of two such: 4202 bits as a sum of four. The highest
/// coefficient of a triple product has six products of 6300 bits, those in the middle 18, where one
/// factor of each is no change: all are below 2^6305, which is 99 limbs.
class ExactPaths {
 public:
  explicit ExactPaths(const FourPaths& paths);

  /// Returns the offset from point `from` to point `to`, along an axis.
  LinearPath offset(int from, int to, int axis) const {
    const LinearPath &a = coordinate_[from][axis], &b = coordinate_[to][axis];
    return {b.start - a.start, b.change - a.change};
  }

 private:
  LinearPath coordinate_[4][3];
};

/// An offset from one point to another, by their numbers in FourPaths.
struct Offset {
  int from;
  int to;
};

/// Returns a component of a x b.
Polynomial cross(const ExactPaths& paths, Offset a, Offset b, int axis);

/// Returns (a x b) . c.
Polynomial triple(const ExactPaths& paths, Offset a, Offset b, Offset c);

/// Returns a polynomial that is zero while all four points are in one plane.
Polynomial volume_of(const ExactPaths& paths, PathPair kind);

}  // namespace graze::narrowphase
