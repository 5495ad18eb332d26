#include <graze/engine/compare/exact_simplex.h>
#include <graze/engine/compare/whole_scale.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace graze::compare {
namespace {

struct Constraint {
  std::vector<int> coefficients;
  Relation relation;
  int right;
};

bool is_feasible(int unknowns, const std::vector<Constraint>& constraints) {
  static ExactSimplex program;  // used again and again, as the referee does
  program.start(unknowns);
  for (const Constraint& constraint : constraints) {
    const int row = program.add_constraint(constraint.relation);
    for (int j = 0; j < unknowns; ++j)
      program.coefficient(row, j) = constraint.coefficients[j];
    program.right(row) = constraint.right;
  }
  return program.is_feasible();
}

constexpr Relation kAtMost = Relation::AtMost;
constexpr Relation kEqual = Relation::Equal;

TEST(ExactSimplex, NoConstraintsAreFeasible) {
  EXPECT_TRUE(is_feasible(2, {}));
}

TEST(ExactSimplex, OneUnknown) {
  EXPECT_TRUE(is_feasible(1, {{{1}, kAtMost, 0}}));
  EXPECT_FALSE(is_feasible(1, {{{1}, kAtMost, -1}}));
  EXPECT_TRUE(is_feasible(1, {{{-1}, kAtMost, -1}}));
  EXPECT_TRUE(is_feasible(1, {{{2}, kEqual, 3}}));
  EXPECT_FALSE(is_feasible(1, {{{2}, kEqual, -3}}));
  EXPECT_TRUE(is_feasible(1, {{{0}, kEqual, 0}}));
  EXPECT_FALSE(is_feasible(1, {{{0}, kEqual, 1}}));
}

TEST(ExactSimplex, BoundsFromBothSides) {
  EXPECT_TRUE(is_feasible(1, {{{-3}, kAtMost, -7}, {{3}, kAtMost, 7}}));
  EXPECT_FALSE(is_feasible(1, {{{-3}, kAtMost, -7}, {{3}, kAtMost, 6}}));
  EXPECT_FALSE(is_feasible(1, {{{-3}, kAtMost, -7}, {{1}, kEqual, 2}}));
}

TEST(ExactSimplex, RedundantAndContradictoryEquations) {
  EXPECT_TRUE(is_feasible(2, {{{1, 1}, kEqual, 2}, {{2, 2}, kEqual, 4}, {{1, -1}, kEqual, 2}}));
  EXPECT_FALSE(is_feasible(2, {{{1, 1}, kEqual, 2}, {{2, 2}, kEqual, 5}}));
  EXPECT_FALSE(is_feasible(2, {{{1, 1}, kEqual, 2}, {{1, -1}, kEqual, 3}}));
}

// A problem of Beale's kind, on which the simplex method runs in a circle unless ties are broken
// with care: many ratios are zero.
TEST(ExactSimplex, ManyTiesStillEnd) {
  EXPECT_TRUE(is_feasible(4, {{{1, -240, -4, 36}, kAtMost, 0},
                              {{1, -180, -2, 6}, kAtMost, 0},
                              {{0, 0, 1, 0}, kAtMost, 1},
                              {{3, -600, 8, -24}, kEqual, 5}}));
  EXPECT_FALSE(is_feasible(4, {{{1, -240, -4, 36}, kAtMost, 0},
                               {{1, -180, -2, 6}, kAtMost, 0},
                               {{0, 0, 1, 0}, kAtMost, 1},
                               {{-1, 180, 2, -6}, kAtMost, -1}}));
}

TEST(WholeScale, KeepsProportionsOverTheWholeRange) {
  const double values[] = {0, -0.0, 0x1.8p-1074 * 2, -0x1p-1022, 1, -0x1.fffffffffffffp+1023};
  WholeScale scale;
  for (const double value : values)
    scale.include(value);
  mpz_class unit;
  scale.whole(1, unit);
  for (const double value : values) {
    mpz_class whole;
    scale.whole(value, whole);
    EXPECT_TRUE(mpq_class(whole) == mpq_class(value) * unit) << value;
  }
}

TEST(WholeScale, TakesOutTheLargestPowerOfTwo) {
  WholeScale scale;
  scale.include(48);
  scale.include(-80);
  mpz_class whole;
  scale.whole(48, whole);
  EXPECT_TRUE(whole == 3);
  scale.whole(-80, whole);
  EXPECT_TRUE(whole == -5);
}

}  // namespace
}  // namespace graze::compare
