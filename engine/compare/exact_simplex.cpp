#include <graze/engine/compare/exact_simplex.h>
#include <cassert>

namespace graze::compare {

void ExactSimplex::start(int unknowns) {
  assert(unknowns <= kMaxUnknowns);
  unknowns_ = unknowns;
  columns_ = 1 + unknowns;
  rows_ = 1;
  denominator_ = 1;
  for (int j = 1; j < columns_; ++j)
    outside_[j] = j;
}

int ExactSimplex::add_constraint(Relation relation) {
  assert(rows_ < kRows);
  relation_[rows_] = relation;
  for (int j = 0; j < columns_; ++j)
    cell_[rows_][j] = 0;
  return rows_++;
}

bool ExactSimplex::is_feasible() {
  choose_first_basis();
  while (sgn(cell_[kObjective][kRight]) > 0) {
    const int column = entering_column();
    if (column == kRight) return false;  // the sum of artificial variables is least, and not zero
    const int row = leaving_row(column);
    pivot(row, column);
    exchange(row, column);
  }
  return true;
}

// A constraint that x = 0 satisfies strictly starts with its own slack as the basic variable; an
// equation, or an inequality that x = 0 violates, starts with an artificial one.
void ExactSimplex::choose_first_basis() {
  for (int i = 1; i < rows_; ++i) {
    const bool is_negative = sgn(cell_[i][kRight]) < 0;
    if (is_negative) {
      for (int j = 0; j < columns_; ++j)
        mpz_neg(cell_[i][j].get_mpz_t(), cell_[i][j].get_mpz_t());
    }
    const bool needs_artificial = is_negative || relation_[i] == Relation::Equal;
    basic_[i] = (needs_artificial ? kFirstArtificial : kFirstSlack) + i;
    if (is_negative && relation_[i] == Relation::AtMost) add_surplus(i);
  }
  for (int j = 0; j < columns_; ++j) {
    mpz_class& sum = cell_[kObjective][j];
    sum = 0;
    for (int i = 1; i < rows_; ++i) {
      if (basic_[i] >= kFirstArtificial) sum += cell_[i][j];
    }
  }
}

// a.x <= b with b < 0 became -a.x - surplus + artificial = -b.
void ExactSimplex::add_surplus(int row) {
  const int column = columns_++;
  for (int i = 1; i < rows_; ++i)
    cell_[i][column] = 0;
  cell_[row][column] = -1;
  outside_[column] = kFirstSlack + row;
}

// Chooses by Bland's rule: of the variables that lower the sum, the one with the smallest number.
// Returns kRight if none does.
int ExactSimplex::entering_column() const {
  int best = kRight;
  for (int j = 1; j < columns_; ++j) {
    if (sgn(cell_[kObjective][j]) <= 0) continue;
    if (best == kRight || outside_[j] < outside_[best]) best = j;
  }
  return best;
}

// Returns the row whose basic variable reaches zero first, and of several the smallest number. One
// exists: the objective's entry is the sum of the artificial rows', so one of these is positive.
int ExactSimplex::leaving_row(int column) {
  int best = 0;
  for (int i = 1; i < rows_; ++i) {
    if (sgn(cell_[i][column]) <= 0) continue;
    if (best == 0 || has_smaller_ratio(i, best, column)) best = i;
  }
  assert(best != 0);
  return best;
}

bool ExactSimplex::has_smaller_ratio(int row_a, int row_b, int column) {
  mpz_mul(product_a_.get_mpz_t(), cell_[row_a][kRight].get_mpz_t(),
          cell_[row_b][column].get_mpz_t());
  mpz_mul(product_b_.get_mpz_t(), cell_[row_b][kRight].get_mpz_t(),
          cell_[row_a][column].get_mpz_t());
  const int order = cmp(product_a_, product_b_);
  return order < 0 || (order == 0 && basic_[row_a] < basic_[row_b]);
}

// Every other row i becomes row_i - row * (cell_i / pivot). Over the new denominator, the pivot,
// that is (cell_ij * pivot - cell_i * row_j) / old denominator, without a remainder: the result is
// a minor of the integer matrix that we began with.
void ExactSimplex::pivot(int row, int column) {
  mpz_srcptr pivot = cell_[row][column].get_mpz_t();
  const bool must_divide = denominator_ != 1;
  mpz_ptr scratch = product_a_.get_mpz_t();
  for (int i = 0; i < rows_; ++i) {
    if (i == row) continue;
    mpz_srcptr factor = cell_[i][column].get_mpz_t();
    for (int j = 0; j < columns_; ++j) {
      if (j == column) continue;
      mpz_ptr cell = cell_[i][j].get_mpz_t();
      mpz_mul(scratch, cell, pivot);
      if (mpz_sgn(factor) != 0) mpz_submul(scratch, factor, cell_[row][j].get_mpz_t());
      if (must_divide && mpz_sgn(scratch) != 0) {
        mpz_divexact(cell, scratch, denominator_.get_mpz_t());
      } else {
        mpz_swap(cell, scratch);
      }
    }
  }
}

// The two variables change places. The column of an artificial variable, which must stay zero from
// now on, is dropped; the last column moves into its place.
void ExactSimplex::exchange(int row, int column) {
  mpz_swap(cell_[row][column].get_mpz_t(), denominator_.get_mpz_t());
  const int left = basic_[row];
  basic_[row] = outside_[column];
  outside_[column] = left;
  if (left >= kFirstArtificial) {
    --columns_;
    outside_[column] = outside_[columns_];
    for (int i = 0; i < rows_; ++i)
      swap(cell_[i][column], cell_[i][columns_]);
    return;
  }
  for (int i = 0; i < rows_; ++i) {
    if (i != row) mpz_neg(cell_[i][column].get_mpz_t(), cell_[i][column].get_mpz_t());
  }
}

}  // namespace graze::compare
