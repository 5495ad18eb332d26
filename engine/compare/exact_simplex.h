#pragma once

#include <gmpxx.h>

#include <array>

namespace graze::compare {

/// Says how the two sides of a linear constraint compare.
enum class Relation { AtMost, Equal };

/// Decides whether a few linear constraints with integer coefficients have a solution in real
/// numbers x >= 0. Phase one of the simplex method: every violated constraint gets an artificial
/// variable, and the sum of these is driven down; it reaches zero if and only if there is a
/// solution. Bland's rule (Bland, "New finite pivoting rules for the simplex method", Mathematics
/// of Operations Research 2(2), 1977) makes it end whatever ties there are.
///
/// The tableau is kept in integers over one common denominator, the last pivot, and every division
/// is exact (Edmonds; Bareiss, "Sylvester's identity and multistep integer-preserving Gaussian
/// elimination", Mathematics of Computation 22, 1968). Keep an object and start() it again: the
/// integers keep their memory.
class ExactSimplex {
 public:
  static constexpr int kMaxUnknowns = 4;
  static constexpr int kMaxConstraints = 7;

  /// Begins a system without constraints; unknowns is at most kMaxUnknowns.
  void start(int unknowns);

  /// Adds the constraint `sum coefficient(row, j) * x_j (relation) right(row)`, all zero until the
  /// caller fills them in, and returns its row. At most kMaxConstraints.
  int add_constraint(Relation relation);

  /// Returns the coefficient of unknown j, counted from zero.
  mpz_class& coefficient(int row, int unknown) { return cell_[row][1 + unknown]; }
  mpz_class& right(int row) { return cell_[row][kRight]; }

  /// True if the system has a solution. It is consumed.
  bool is_feasible();

 private:
  static constexpr int kObjective = 0;  ///< the row of the sum of artificial variables
  static constexpr int kRight = 0;      ///< the column of the right-hand sides
  static constexpr int kRows = 1 + kMaxConstraints;
  static constexpr int kColumns = 1 + kMaxUnknowns + kMaxConstraints;
  static constexpr int kFirstSlack = 1 + kMaxUnknowns;
  static constexpr int kFirstArtificial = kFirstSlack + kRows;

  void choose_first_basis();
  void add_surplus(int row);
  int entering_column() const;
  int leaving_row(int column);
  bool has_smaller_ratio(int row_a, int row_b, int column);
  void pivot(int row, int column);
  void exchange(int row, int column);

  /// Row i reads: basic_[i] = (cell_[i][kRight] - sum_j cell_[i][j] * outside_[j]) / denominator_.
  std::array<std::array<mpz_class, kColumns>, kRows> cell_;
  mpz_class denominator_;
  mpz_class product_a_;
  mpz_class product_b_;
  std::array<Relation, kRows> relation_{};
  std::array<int, kRows> basic_{};       ///< the variable that row i is solved for
  std::array<int, kColumns> outside_{};  ///< the variable of column j, which is zero
  int rows_ = 0;
  int columns_ = 0;
  int unknowns_ = 0;
};

}  // namespace graze::compare
