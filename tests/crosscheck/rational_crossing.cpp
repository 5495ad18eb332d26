#include <gmpxx.h>
#include <tests/compare/fourier_motzkin.h>
#include <tests/crosscheck/rational_crossing.h>

#include <array>
#include <utility>
#include <vector>

namespace graze::oracle {
namespace {

using Row = std::vector<mpq_class>;

std::array<Eigen::Vector3d, 6> points_of(const Triangle& a, const Triangle& b) {
  return {a.a, a.b, a.c, b.a, b.b, b.c};
}

/// By Gauss's elimination.
int rank_of(std::vector<Row> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 3; ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column] == 0)
      ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const mpq_class factor = rows[i][column] / rows[rank][column];
      for (std::size_t k = column; k < 3; ++k)
        rows[i][k] -= factor * rows[rank][k];
    }
    ++rank;
  }
  return static_cast<int>(rank);
}

bool are_coplanar(const std::array<Eigen::Vector3d, 6>& points) {
  std::vector<Row> rows;
  for (int i = 1; i < 6; ++i) {
    Row row;
    for (int k = 0; k < 3; ++k)
      row.push_back(mpq_class(points[i][k]) - mpq_class(points[0][k]));
    rows.push_back(row);
  }
  return rank_of(rows) < 3;
}

/// Weights of at least 1, not of sum 1: scaled by that sum they are positive weights of sum 1.
bool do_relative_interiors_meet(const std::array<Eigen::Vector3d, 6>& points) {
  LinearSystem system(6);
  for (int k = 0; k < 4; ++k) {
    Row row;
    for (int i = 0; i < 6; ++i) {
      const mpq_class entry = k < 3 ? mpq_class(points[i][k]) : mpq_class(1);
      row.push_back(i < 3 ? entry : mpq_class(-entry));
    }
    row.push_back(0);
    system.add_equal(row);
  }
  for (int i = 0; i < 6; ++i) {
    Row row(7);
    row[i] = -1;
    row[6] = -1;
    system.add_at_most(row);
  }
  return system.is_feasible();
}

}  // namespace

bool crosses_by_elimination(const Triangle& triangle_a, const Triangle& triangle_b) {
  const auto points = points_of(triangle_a, triangle_b);
  return !are_coplanar(points) && do_relative_interiors_meet(points);
}

}  // namespace graze::oracle
