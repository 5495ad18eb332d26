#pragma once

#include <gmpxx.h>

#include <vector>

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/triangle.h>

namespace graze::oracle {

/// Decides linear systems over the rationals by elimination: equations by substitution, then one
/// unknown after the other by Fourier and Motzkin's method. It keeps no basis and makes no pivoting
/// choices, and judges the referee, which does.
class LinearSystem {
 public:
  explicit LinearSystem(int unknowns) : unknowns_(unknowns) {}

  /// Row: one coefficient for each unknown, then the right-hand side.
  void add_at_most(std::vector<mpq_class> row) { inequalities_.push_back(std::move(row)); }
  void add_equal(std::vector<mpq_class> row) { equations_.push_back(std::move(row)); }

  /// Consumes the system.
  bool is_feasible();

 private:
  using Row = std::vector<mpq_class>;
  bool substitute_equations();
  void eliminate(int unknown);

  int unknowns_;
  std::vector<Row> equations_;
  std::vector<Row> inequalities_;
};

bool intersects_by_elimination(const Triangle& triangle_a, const Triangle& triangle_b);
bool intersects_by_elimination(const Triangle& triangle, const Aabb& box);

}  // namespace graze::oracle
