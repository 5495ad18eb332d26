// Integers of any length beside GMP's, and polynomials of them beside rational ones.

#include <gmpxx.h>
#include <graze/narrowphase/motion/long_roots.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/narrowphase/motion/rational_polynomial.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::GrowingInteger;
using narrowphase::LongPolynomial;
using narrowphase::Sign;

struct Both {
  GrowingInteger own;
  mpz_class other;
};

/// Of up to so many words.
Both random_integer(RandomSource& source, int words) {
  Both both;
  const int count = static_cast<int>(source.integer(0, words));
  for (int i = 0; i < 2 * count; ++i) {
    const double digit = source.integer(0, 3) == 0 ? 0 : std::floor(source.uniform(0, 0x1p32));
    both.own = both.own.shifted(32) + GrowingInteger::from_double(digit, 0);
    both.other = (both.other << 32) + mpz_class(digit);
  }
  if (source.integer(0, 1) != 0) both = {-both.own, -both.other};
  return both;
}

bool are_equal(const GrowingInteger& own, const mpz_class& other) {
  GrowingInteger rest = own;
  mpz_class theirs = other;
  if (static_cast<int>(own.sign()) != sgn(other)) return false;
  if (own.bit_length() != (other == 0 ? 0 : static_cast<int>(mpz_sizeinbase(other.get_mpz_t(), 2))))
    return false;
  // By thirty bits, from the lowest on.
  while (!rest.is_zero()) {
    const GrowingInteger next = rest.shifted_down(30);
    const mpz_class their_next = theirs / mpz_class(1 << 30);
    const mpz_class digit = theirs - (their_next << 30);
    if ((rest - next.shifted(30)).to_double() != digit.get_d()) return false;
    rest = next;
    theirs = their_next;
  }
  return theirs == 0;
}

TEST(GrowingIntegers, AreThoseOfGmp) {
  RandomSource source(77);
  for (int n = 0; n < 400; ++n) {
    const Both a = random_integer(source, 12), b = random_integer(source, 7);
    ASSERT_TRUE(are_equal(a.own, a.other)) << n;
    ASSERT_TRUE(are_equal(a.own + b.own, a.other + b.other)) << n;
    ASSERT_TRUE(are_equal(a.own - b.own, a.other - b.other)) << n;
    ASSERT_TRUE(are_equal(a.own - a.own, 0)) << n;
    ASSERT_TRUE(are_equal(a.own * b.own, a.other * b.other)) << n;
    const int bits = static_cast<int>(source.integer(0, 200));
    ASSERT_TRUE(are_equal(a.own.shifted(bits), a.other << bits)) << n;
    if (b.other == 0) continue;
    ASSERT_TRUE(are_equal(exact_quotient(a.own * b.own, b.own), a.other)) << n;
    ASSERT_TRUE(
        are_equal(exact_quotient((a.own * b.own).shifted(bits), b.own.shifted(bits)), a.other))
        << n;
  }
}

TEST(GrowingIntegers, AreMadeOfDoubles) {
  EXPECT_TRUE(are_equal(GrowingInteger::from_double(-0x1.8p-1073, -1074), -3));
  EXPECT_TRUE(are_equal(GrowingInteger::from_double(0x1p1023, -1074), mpz_class(1) << 2097));
  EXPECT_TRUE(are_equal(GrowingInteger(-7), -7));
  EXPECT_TRUE(GrowingInteger::from_double(0, 5).is_zero());
}

struct BothPolynomials {
  LongPolynomial own;
  oracle::RationalPolynomial other;
};

BothPolynomials random_polynomial(RandomSource& source, int degree) {
  std::vector<GrowingInteger> own;
  BothPolynomials both;
  for (int i = 0; i <= degree; ++i) {
    const int value = static_cast<int>(source.integer(-9, 9));
    own.emplace_back(value);
    both.other.emplace_back(value);
  }
  while (!both.other.empty() && both.other.back() == 0)
    both.other.pop_back();
  both.own = LongPolynomial(own);
  return both;
}

BothPolynomials product(const BothPolynomials& f, const BothPolynomials& g) {
  return {f.own * g.own, oracle::operator*(f.other, g.other)};
}

/// Roots and signs of others there, of polynomials that have roots in common, and twice.
TEST(LongRoots, AreThoseOfSturm) {
  RandomSource source(78);
  int roots_found = 0, common = 0;
  for (int n = 0; n < 200; ++n) {
    const BothPolynomials part = random_polynomial(source, 1 + n % 3);
    BothPolynomials f = product(part, random_polynomial(source, 1 + n % 2));
    if (n % 4 == 0) f = product(f, part);
    const BothPolynomials g =
        n % 2 == 0 ? product(part, random_polynomial(source, 1)) : random_polynomial(source, 3);
    if (f.other.empty()) continue;
    LongPolynomial simple;
    std::vector<narrowphase::LongRoot> own = narrowphase::long_roots_of(f.own, simple);
    const oracle::RationalPolynomial square_free =
        oracle::square_free(oracle::in_integers(f.other));
    std::vector<oracle::RationalRoot> right = oracle::roots_of(square_free);
    // Those at 0 are not asked for.
    if (f.other[0] == 0) right.erase(right.begin());
    ASSERT_EQ(own.size(), right.size()) << n;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const int sign =
          g.other.empty() ? 0 : oracle::sign_at(oracle::in_integers(g.other), right[i]);
      ASSERT_EQ(static_cast<int>(own[i].sign_of(g.own)), sign) << n << " " << i;
      ASSERT_EQ(own[i].rounded_down(), oracle::rounded_down(right[i])) << n << " " << i;
      ++roots_found;
      common += sign == 0;
    }
  }
  EXPECT_GT(roots_found, 100);
  EXPECT_GT(common, 20);
}

}  // namespace
}  // namespace graze
