#pragma once

// Finds the sign of one polynomial at a root of another.
//
// The integers become as long as follows. f, whose root it is, has coefficients of at most 6305
// bits, g of 4202 (polynomial.h). Where f has a multiple root, its roots are those of lines whose
// coefficients are products of three of f's: 18930 bits. Ends of stretches are doubles, multiples
// of 2^-1074; or finer, where two roots of f lie between neighbours. Such roots are further apart
// than 2^-12618 (Mahler, "An inequality for the discriminant of a polynomial", Michigan
// Mathematical Journal 11, 1964: at least the root of three times the discriminant, over 9 and the
// square of the length of the coefficients), so that 13700 bits behind the point are enough for the
// ends.
//
//   the discriminant of f                        25230 bits
//   f, or its Bernstein coefficients, at ends    6305 + 3 * 13700 + 8 = 47413
//   g at ends                                    4202 + 2 * 13700 + 8 = 31610
//   f at the vertex of g, of 4204 bits           6305 + 3 * 4204 + 8 = 18925
//   f reduced by g                               6305 + 2 * 4202 + 4 = 14713
//   g at the root of that                        4202 + 2 * 14713 + 4 = 33632
//   g at the root of a line                      4202 + 2 * 18930 + 4 = 42066
//
// Of these the longest takes 741 limbs and, since a product asks for the limbs of its factors
// together, each rounded up, a few more: HugeInteger has 768. Nearly always 200 are enough, and
// those are tried first.

#include <graze/narrowphase/motion/roots.h>

namespace graze::narrowphase {

/// Returns the sign of g just after t; the next function returns that just before. Each is its own
/// sign at t, or that of the first derivative that is not zero, which just before t is negated if
/// the derivative is of odd order.
template <typename SignAt>
Sign sign_after(const Polynomial& g, const SignAt& sign_of) {
  const Sign sign = sign_of(g);
  return sign != Sign::Zero || g.degree < 1 ? sign : sign_after(derivative(g), sign_of);
}

template <typename SignAt>
Sign sign_before(const Polynomial& g, const SignAt& sign_of) {
  const Sign sign = sign_of(g);
  return sign != Sign::Zero || g.degree < 1 ? sign : -sign_before(derivative(g), sign_of);
}

/// Finds signs of polynomials of degree two at most, at a root that stands alone in its stretch.
template <typename Integer>
class RootSigns {
 public:
  explicit RootSigns(const Root<Integer>& root) : f_(root.f), place_(root.place) {}

  Sign operator()(const Polynomial& g) const {
    if (g.degree < 1 || place_.is_one_time) return sign_at(g, place_.low);
    Sign sign[4];
    bernstein_signs(g, place_.low, place_.high, sign);
    if (count_changes(sign, g.degree) == 0) {
      // In the open stretch g has the sign of those coefficients that are not zero.
      for (int i = 0; i <= g.degree; ++i) {
        if (sign[i] != Sign::Zero) return sign[i];
      }
    }
    return sign_by_roots(g);
  }

 private:
  /// A part of the stretch, in which f has its root and g has one at most.
  struct Part {
    const Fraction<Integer>* vertex = nullptr;  ///< the vertex of g, if that is one of the ends
    bool is_before_vertex = false;
    Sign low;  ///< the sign of g just after the beginning, and just before the end
    Sign high;
  };

  Sign sign_by_roots(const Polynomial& g) const {
    Part part;
    part.low = sign_after(g, [&](const Polynomial& h) { return sign_at(h, place_.low); });
    part.high = sign_before(g, [&](const Polynomial& h) { return sign_at(h, place_.high); });
    if (part.low != part.high) return sign_beside_root(g, part);
    if (g.degree < 2) return part.low;
    // There are two roots, or none, on either side of the vertex.
    const auto vertex = Fraction<Integer>::root_of(whole<Integer>(2) * Integer(g.coefficient[2]),
                                                   Integer(g.coefficient[1]));
    if (compare(vertex, place_.low) != Sign::Positive ||
        compare(vertex, place_.high) != Sign::Negative)
      return part.low;
    const Sign extreme = sign_at(g, vertex);
    if (extreme == part.low) return extreme;
    const Sign f_there = sign_at(f_, vertex);
    if (f_there == Sign::Zero) return extreme;
    if (extreme == Sign::Zero) return part.low;
    part.vertex = &vertex;
    part.is_before_vertex = f_there != sign_at(f_, place_.low);
    (part.is_before_vertex ? part.high : part.low) = extreme;
    return sign_beside_root(g, part);
  }

  /// Returns the sign of g where it has one root in the part, and changes its sign there. f has the
  /// sign of its beginning there if its own root comes later.
  Sign sign_beside_root(const Polynomial& g, const Part& part) const {
    const Sign f_there = g.degree == 1
                             ? sign_at(f_, Fraction<Integer>::root_of(Integer(g.coefficient[1]),
                                                                      Integer(g.coefficient[0])))
                             : sign_at_root_of_square(g, part);
    if (f_there == Sign::Zero) return Sign::Zero;
    return f_there == sign_at(f_, place_.low) ? part.high : part.low;
  }

  /// Returns the sign of f at the root of g = p t^2 + q t + r: it is that of a line, for f less
  /// that line is a multiple of g.
  Sign sign_at_root_of_square(const Polynomial& g, const Part& part) const {
    Integer remainder[4];
    for (int i = 0; i <= f_.degree; ++i)
      remainder[i] = f_.coefficient[i];
    const Integer p(g.coefficient[2]), q(g.coefficient[1]), r(g.coefficient[0]);
    Sign factor = Sign::Positive;  // the sign of what f has been multiplied by
    for (int i = f_.degree; i >= 2; --i) {
      const Integer highest = remainder[i];
      for (int k = 0; k < i; ++k)
        remainder[k] = remainder[k] * p;
      remainder[i - 1] = remainder[i - 1] - highest * q;
      remainder[i - 2] = remainder[i - 2] - highest * r;
      if (p.sign() == Sign::Negative) factor = -factor;
    }
    const Sign slope = remainder[1].sign();
    const Sign sign = slope == Sign::Zero ? remainder[0].sign()
                                          : sign_of_line(g, part, remainder[1], remainder[0]);
    return factor == Sign::Negative ? -sign : sign;
  }

  /// Returns the sign of a line, which is not level, at the root of g.
  Sign sign_of_line(const Polynomial& g, const Part& part, const Integer& slope,
                    const Integer& offset) const {
    const auto zero = Fraction<Integer>::root_of(slope, offset);
    const bool starts_at_vertex = part.vertex != nullptr && !part.is_before_vertex;
    const bool ends_at_vertex = part.vertex != nullptr && part.is_before_vertex;
    const Sign past_low =
        starts_at_vertex ? compare(zero, *part.vertex) : compare(zero, place_.low);
    if (past_low != Sign::Positive) return slope.sign();
    const Sign past_high =
        ends_at_vertex ? compare(zero, *part.vertex) : compare(zero, place_.high);
    if (past_high != Sign::Negative) return -slope.sign();
    const Sign g_there = sign_at(g, zero);
    if (g_there == Sign::Zero) return Sign::Zero;
    return g_there == part.low ? slope.sign() : -slope.sign();
  }

  const IntegerPolynomial<Integer>& f_;
  const Stretch<Integer>& place_;
};

}  // namespace graze::narrowphase
