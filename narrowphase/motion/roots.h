#pragma once

// Finds the real roots of a polynomial in a stretch of time, each exactly, first to last.

#include <graze/narrowphase/motion/times.h>

namespace graze::narrowphase {

/// Times between which a polynomial may have roots; or one time, at which it has one.
template <typename Integer>
struct Stretch {
  Dyadic<Integer> low;
  Dyadic<Integer> high;  ///< unspecified if it is one time
  int changes = 0;       ///< changes of sign among the Bernstein coefficients between the two
  bool is_one_time = false;
};

/// Returns the coefficients of f in Bernstein's basis between two times, each times something
/// positive. They are the values of its polar form: coefficient j is that at d - j times low and j
/// times high, for degree d.
template <typename Coefficient, typename Integer>
void bernstein_signs(const IntegerPolynomial<Coefficient>& f, const Dyadic<Integer>& low,
                     const Dyadic<Integer>& high, Sign (&sign)[4]) {
  const int bits = low.bits > high.bits ? low.bits : high.bits;
  sign[0] = sign_at(f, low);
  sign[f.degree < 0 ? 0 : f.degree] = sign_at(f, high);
  if (f.degree < 2) return;
  const Integer a = low.numerator.shifted(bits - low.bits);
  const Integer b = high.numerator.shifted(bits - high.bits);
  const Integer two = whole<Integer>(2);
  if (f.degree == 2) {
    sign[1] = (Integer(f.coefficient[0]).shifted(2 * bits + 1) +
               (Integer(f.coefficient[1]) * (a + b)).shifted(bits) +
               Integer(f.coefficient[2]) * two * a * b)
                  .sign();
    return;
  }
  const Integer three = whole<Integer>(3);
  const Integer constant = (Integer(f.coefficient[0]) * three).shifted(3 * bits);
  const auto at = [&](const Integer& twice, const Integer& once) {
    const Integer linear = (Integer(f.coefficient[1]) * (two * twice + once)).shifted(2 * bits);
    const Integer square =
        (Integer(f.coefficient[2]) * (twice * (twice + two * once))).shifted(bits);
    const Integer cube = Integer(f.coefficient[3]) * three * (twice * twice * once);
    return (constant + linear + square + cube).sign();
  };
  sign[1] = at(a, b);
  sign[2] = at(b, a);
}

inline int count_changes(const Sign (&sign)[4], int degree) {
  int changes = 0;
  Sign last = Sign::Zero;
  for (int i = 0; i <= degree; ++i) {
    if (sign[i] == Sign::Zero) continue;
    changes += last != Sign::Zero && sign[i] != last;
    last = sign[i];
  }
  return changes;
}

/// A root that stands alone between two times, at which the polynomial has different signs; or one
/// that is a dyadic number itself.
template <typename Integer>
struct Root {
  const IntegerPolynomial<Integer>& f;
  Stretch<Integer> place;
};

/// Returns roughly where f has its root between two doubles, by halving in rounded arithmetic.
double rough_root(const double (&coefficient)[4], int degree, double low, double high);

/// Divides the coefficients by the largest of them, rounded; those too small for that are zero.
template <typename Integer>
void rough_coefficients(const IntegerPolynomial<Integer>& f, double (&coefficient)[4]) {
  int largest = 0;
  bool has_any = false;
  for (int i = 0; i <= f.degree; ++i) {
    if (f.coefficient[i].is_zero()) continue;
    const int exponent = f.coefficient[i].leading().exponent;
    if (!has_any || exponent > largest) largest = exponent;
    has_any = true;
  }
  for (int i = 0; i < 4; ++i) {
    coefficient[i] = 0;
    if (i > f.degree || f.coefficient[i].is_zero()) continue;
    const auto leading = f.coefficient[i].leading();
    const double size = std::ldexp(static_cast<double>(leading.high), leading.exponent - largest);
    coefficient[i] = f.coefficient[i].sign() == Sign::Negative ? -size : size;
  }
}

/// Moves one end of the root's stretch to a double within it, or finds that the root is there.
template <typename Integer>
void move_end(Root<Integer>& root, Sign sign_low, double time) {
  const Dyadic<Integer> middle(time);
  const Sign sign = sign_at(root.f, middle);
  if (sign == sign_low) {
    root.place.low = middle;
  } else if (sign == Sign::Zero) {
    root.place.low = middle;
    root.place.is_one_time = true;
  } else {
    root.place.high = middle;
  }
}

/// Narrows the root's stretch until its ends are neighbours among doubles: steps lead out from a
/// guess and grow, then halving goes on.
template <typename Integer>
void narrow(Root<Integer>& root) {
  Stretch<Integer>& place = root.place;
  if (place.is_one_time || are_neighbours(place.low, place.high)) return;
  const Sign sign_low = sign_at(root.f, place.low);
  double coefficient[4];
  rough_coefficients(root.f, coefficient);
  const double guess = rough_root(coefficient, root.f.degree, place.low.floor, place.high.floor);
  if (guess > place.low.floor && guess < place.high.floor) move_end(root, sign_low, guess);
  const auto bits_of = [](const Dyadic<Integer>& time) {
    return std::bit_cast<std::uint64_t>(time.floor);
  };
  const bool is_above = place.low.floor == guess;
  for (std::uint64_t step = 1; !place.is_one_time; step *= 4) {
    const std::uint64_t low = bits_of(place.low), high = bits_of(place.high);
    if (high - low <= 2 * step) break;
    const Dyadic<Integer> before = is_above ? place.high : place.low;
    move_end(root, sign_low, std::bit_cast<double>(is_above ? low + step : high - step));
    if ((is_above ? place.high : place.low).floor != before.floor) break;
  }
  while (!place.is_one_time && !are_neighbours(place.low, place.high))
    move_end(root, sign_low, double_between(place.low.floor, place.high.floor));
}

/// Calls `visit(Root&)` for the roots of f in [from, 1], first to last, until it returns true. The
/// polynomial has no multiple roots. This follows the rule of Descartes for Bernstein's basis: no
/// change of sign means no root in the open stretch, one change means one, and halving comes to
/// that for each root in the end (Collins and Akritas, "Polynomial real root isolation using
/// Descartes' rule of signs", SYMSAC 1976; Mehlhorn and Sagraloff, "A deterministic algorithm for
/// isolating real roots of a real polynomial", Journal of Symbolic Computation 46(1), 2011).
/// Changes in two halves are no more than those in the whole, so that at most three stretches and
/// roots wait, and a fourth for a moment.
template <typename Integer, typename Visit>
bool visit_simple_roots(const IntegerPolynomial<Integer>& f, double from, const Visit& visit) {
  if (f.degree < 1) return false;
  Stretch<Integer> waiting[6];  // the next one last
  int count = 0;
  const auto wait_at = [&](const Dyadic<Integer>& time) {
    waiting[count].low = time;
    waiting[count++].is_one_time = true;
  };
  const auto wait_between = [&](const Dyadic<Integer>& low, const Dyadic<Integer>& high) {
    Sign sign[4];
    bernstein_signs(f, low, high, sign);
    const int changes = count_changes(sign, f.degree);
    if (changes == 0) return;
    waiting[count++] = {low, high, changes, false};
  };
  const Dyadic<Integer> first(from), last(1);
  if (from < 1 && sign_at(f, last) == Sign::Zero) wait_at(last);
  if (from < 1) wait_between(first, last);
  if (sign_at(f, first) == Sign::Zero) wait_at(first);
  while (count > 0) {
    const Stretch<Integer> place = waiting[--count];
    if (place.is_one_time || (place.changes == 1 && sign_at(f, place.low) != Sign::Zero &&
                              sign_at(f, place.high) != Sign::Zero)) {
      Root<Integer> root{f, place};
      if (visit(root)) return true;
      continue;
    }
    const Dyadic<Integer> middle = between(place.low, place.high);
    wait_between(middle, place.high);
    if (sign_at(f, middle) == Sign::Zero) wait_at(middle);
    wait_between(place.low, middle);
  }
  return false;
}

/// Does the same for a polynomial that has one real root in all, where signs at the ends tell it.
template <typename Integer, typename Visit>
bool visit_only_root(const IntegerPolynomial<Integer>& f, double from, const Visit& visit) {
  Stretch<Integer> place{Dyadic<Integer>(from), Dyadic<Integer>(1), 1, false};
  const Sign first = sign_at(f, place.low), last = sign_at(f, place.high);
  if (first == last && first != Sign::Zero) return false;
  if (last == Sign::Zero) place.low = place.high;
  place.is_one_time = first == Sign::Zero || last == Sign::Zero;
  Root<Integer> root{f, place};
  return visit(root);
}

/// Returns slope t + offset.
template <typename Integer>
IntegerPolynomial<Integer> line(const Integer& slope, const Integer& offset) {
  IntegerPolynomial<Integer> f;
  f.coefficient[0] = offset;
  f.coefficient[1] = slope;
  f.take(2);
  return f;
}

/// Visits the roots of a t^3 + b t^2 + c t + d. Its discriminant is a sum of five products of four
/// coefficients, negative if there is one real root, which then no halving has to part from others.
/// If it is zero, the remainder of 9 a f by f' is (6 a c - 2 b^2) t + (9 a d - b c), which is zero
/// at a double root, and zero altogether if the root is triple. The roots add up to -b / a.
template <typename Integer, typename Visit>
bool visit_cubic_roots(const IntegerPolynomial<Integer>& f, double from, const Visit& visit) {
  const Integer &a = f.coefficient[3], &b = f.coefficient[2];
  const Integer &c = f.coefficient[1], &d = f.coefficient[0];
  const Integer ac = a * c, ad = a * d, bb = b * b, bc = b * c;
  const Integer discriminant =
      ((bb * c * c - whole<Integer>(4) * ac * c * c) - whole<Integer>(4) * bb * b * d) +
      (whole<Integer>(18) * ad * bc - whole<Integer>(27) * ad * ad);
  if (discriminant.sign() == Sign::Negative) return visit_only_root(f, from, visit);
  if (discriminant.sign() == Sign::Positive) return visit_simple_roots(f, from, visit);
  const Integer slope = whole<Integer>(2) * (whole<Integer>(3) * ac - bb);
  if (slope.is_zero()) return visit_simple_roots(line(whole<Integer>(3) * a, b), from, visit);
  const Integer offset = whole<Integer>(9) * ad - bc;
  const Integer other_offset = b * slope - whole<Integer>(2) * a * offset;
  const bool stops = visit_simple_roots(line(slope, offset), from, visit);
  return visit_simple_roots(line(a * slope, other_offset), from, visit) || stops;
}

template <typename Integer>
IntegerPolynomial<Integer> in_integers(const Polynomial& given) {
  IntegerPolynomial<Integer> f;
  for (int i = 0; i <= given.degree; ++i)
    f.coefficient[i] = Integer(given.coefficient[i]);
  f.degree = given.degree;
  return f;
}

/// Does what visit_simple_roots() does, for any polynomial that is not zero. A multiple root is
/// visited once, and a simple one beside it after it, whichever comes first.
template <typename Integer, typename Visit>
bool visit_roots(const Polynomial& given, double from, const Visit& visit) {
  const IntegerPolynomial<Integer> f = in_integers<Integer>(given);
  if (f.degree < 2) return visit_simple_roots(f, from, visit);
  Sign sign[4];
  bernstein_signs(f, Dyadic<Integer>(from), Dyadic<Integer>(1), sign);
  if (count_changes(sign, f.degree) < 2) return visit_simple_roots(f, from, visit);
  if (f.degree == 3) return visit_cubic_roots(f, from, visit);
  const Integer &a = f.coefficient[2], &b = f.coefficient[1];
  const Integer discriminant = b * b - whole<Integer>(4) * a * f.coefficient[0];
  if (discriminant.sign() == Sign::Negative) return false;
  if (discriminant.sign() == Sign::Positive) return visit_simple_roots(f, from, visit);
  return visit_simple_roots(line(whole<Integer>(2) * a, b), from, visit);
}

}  // namespace graze::narrowphase
