#include <tests/compare/fourier_motzkin.h>
#include <algorithm>
#include <utility>

namespace graze::oracle {
namespace {

using Row = std::vector<mpq_class>;

// row := row - factor * other, where factor makes the entry of `unknown` zero.
void cancel(Row& row, const Row& other, int unknown) {
  if (row[unknown] == 0) return;
  const mpq_class factor = row[unknown] / other[unknown];
  for (std::size_t k = 0; k < row.size(); ++k)
    row[k] -= factor * other[k];
}

// w_i >= 0 and w_i + w_j <= 1 for the weights of two vertices, of four unknowns at most.
void add_weights(LinearSystem& system, int unknowns, int first) {
  for (int i = first; i < first + 2; ++i) {
    Row row(unknowns + 1);
    row[i] = -1;
    system.add_at_most(row);
  }
  Row sum(unknowns + 1);
  sum[first] = 1;
  sum[first + 1] = 1;
  sum[unknowns] = 1;
  system.add_at_most(sum);
}

}  // namespace

bool LinearSystem::is_feasible() {
  if (!substitute_equations()) return false;
  for (int unknown = 0; unknown < unknowns_; ++unknown)
    eliminate(unknown);
  return std::all_of(inequalities_.begin(), inequalities_.end(),
                     [](const Row& row) { return row.back() >= 0; });
}

bool LinearSystem::substitute_equations() {
  while (!equations_.empty()) {
    const Row equation = std::move(equations_.back());
    equations_.pop_back();
    const auto entry = std::find_if(equation.begin(), equation.end() - 1,
                                    [](const mpq_class& value) { return value != 0; });
    const int unknown = static_cast<int>(entry - equation.begin());
    if (unknown == unknowns_) {
      if (equation.back() != 0) return false;
      continue;
    }
    for (Row& row : equations_)
      cancel(row, equation, unknown);
    for (Row& row : inequalities_)
      cancel(row, equation, unknown);
  }
  return true;
}

// Every lower bound of the unknown must be at most every upper bound.
void LinearSystem::eliminate(int unknown) {
  std::vector<Row> remaining;
  for (const Row& upper : inequalities_) {
    if (upper[unknown] == 0) remaining.push_back(upper);
    if (upper[unknown] <= 0) continue;
    for (const Row& lower : inequalities_) {
      if (lower[unknown] >= 0) continue;
      Row sum(upper.size());
      for (std::size_t k = 0; k < sum.size(); ++k) {
        sum[k] = upper[k] / upper[unknown] - lower[k] / lower[unknown];
      }
      remaining.push_back(std::move(sum));
    }
  }
  std::sort(remaining.begin(), remaining.end());
  remaining.erase(std::unique(remaining.begin(), remaining.end()), remaining.end());
  inequalities_ = std::move(remaining);
}

bool intersects_by_elimination(const Triangle& triangle_a, const Triangle& triangle_b) {
  LinearSystem system(4);
  add_weights(system, 4, 0);
  add_weights(system, 4, 2);
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class p(triangle_a.a.data()[axis]);
    const mpq_class q(triangle_b.a.data()[axis]);
    system.add_equal({mpq_class(triangle_a.b.data()[axis]) - p,
                      mpq_class(triangle_a.c.data()[axis]) - p,
                      q - mpq_class(triangle_b.b.data()[axis]),
                      q - mpq_class(triangle_b.c.data()[axis]), q - p});
  }
  return system.is_feasible();
}

bool intersects_by_elimination(const Triangle& triangle, const Aabb& box) {
  LinearSystem system(2);
  add_weights(system, 2, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class p(triangle.a.data()[axis]);
    const mpq_class u = mpq_class(triangle.b.data()[axis]) - p;
    const mpq_class v = mpq_class(triangle.c.data()[axis]) - p;
    system.add_at_most({u, v, mpq_class(box.max.data()[axis]) - p});
    system.add_at_most({-u, -v, p - mpq_class(box.min.data()[axis])});
  }
  return system.is_feasible();
}

}  // namespace graze::oracle
