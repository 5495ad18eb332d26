#include "tests/narrowphase/volumes/rational_boxes.h"

#include <gmpxx.h>

#include <array>
#include <cmath>

namespace graze::oracle {
namespace {

using Rational = std::array<mpq_class, 3>;
using Integer = std::array<mpz_class, 3>;

/// centre + sum of y_j half_j axis_j with |y_j| <= 1.
struct Parallelepiped {
  Rational centre;
  std::array<Rational, 3> axis;
  Rational half;
};

template <typename Vector>
Vector cross(const Vector& p, const Vector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

template <typename Vector>
auto dot(const Vector& p, const Vector& q) {
  return typename Vector::value_type(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
}

Rational exactly(const double* v) {
  return {mpq_class(v[0]), mpq_class(v[1]), mpq_class(v[2])};
}

Parallelepiped exactly(const Obb& box, Reading reading) {
  const double* m = box.pose.data();
  Parallelepiped result{exactly(m + 12),
                        {exactly(m), exactly(m + 4), exactly(m + 8)},
                        exactly(box.half_extents.data())};
  if (reading == Reading::Image) return result;
  // The columns of R^-T are products of those of R, divided by the determinant.
  const std::array<Rational, 3> column = result.axis;
  const mpq_class determinant = dot(column[0], cross(column[1], column[2]));
  for (std::size_t j = 0; j < 3; ++j) {
    result.axis[j] = cross(column[(j + 1) % 3], column[(j + 2) % 3]);
    for (mpq_class& component : result.axis[j])
      component /= determinant;
  }
  return result;
}

Parallelepiped exactly(const Aabb& box) {
  const Rational min = exactly(box.min.data()), max = exactly(box.max.data());
  Parallelepiped result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = (min[i] + max[i]) / 2;
    result.half[i] = (max[i] - min[i]) / 2;
    result.axis[i] = {mpq_class(0), mpq_class(0), mpq_class(0)};
    result.axis[i][i] = 1;
  }
  return result;
}

/// Numbers made whole by a common factor: integers are ten times as fast.
class CommonFactor {
 public:
  void cover(const Rational& v) {
    for (const mpq_class& value : v)
      factor_ = lcm(factor_, value.get_den());
  }
  const mpz_class& factor() const { return factor_; }

  Integer whole(const Rational& v) const {
    Integer result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = v[i].get_num() * (factor_ / v[i].get_den());
    return result;
  }

 private:
  mpz_class factor_ = 1;
};

/// value / factor, with one rounding toward zero, at any magnitude.
double quotient(const mpz_class& value, const mpz_class& factor) {
  return mpq_class(value, factor).get_d();
}

class Axes {
 public:
  Axes(const Parallelepiped& a, const Parallelepiped& b) {
    const Rational between{b.centre[0] - a.centre[0], b.centre[1] - a.centre[1],
                           b.centre[2] - a.centre[2]};
    for (const Parallelepiped* box : {&a, &b}) {
      lengths_.cover(box->half);
      for (const Rational& axis : box->axis)
        directions_.cover(axis);
    }
    lengths_.cover(between);
    between_ = lengths_.whole(between);
    for (mpz_class& component : between_)
      component *= directions_.factor();  // as reaches are lengths times directions
    for (std::size_t j = 0; j < 3; ++j) {
      axis_a_[j] = directions_.whole(a.axis[j]);
      axis_b_[j] = directions_.whole(b.axis[j]);
    }
    half_a_ = lengths_.whole(a.half);
    half_b_ = lengths_.whole(b.half);
  }

  Separation separation() {
    for (std::size_t j = 0; j < 3; ++j) {
      add(cross(axis_a_[(j + 1) % 3], axis_a_[(j + 2) % 3]), true);
      add(cross(axis_b_[(j + 1) % 3], axis_b_[(j + 2) % 3]), true);
      for (std::size_t k = 0; k < 3; ++k)
        add(cross(axis_a_[j], axis_b_[k]), false);
    }
    return result_;
  }

 private:
  void add(const Integer& line, bool is_face) {
    mpz_class gap = abs(dot(line, between_));
    for (std::size_t j = 0; j < 3; ++j)
      gap -= half_a_[j] * abs(dot(line, axis_a_[j])) + half_b_[j] * abs(dot(line, axis_b_[j]));
    const mpz_class length2 = dot(line, line);
    if (length2 == 0) return;  // parallel edges
    result_.is_apart |= gap > 0;
    const mpz_class& unit = directions_.factor();
    const mpz_class unit2 = unit * unit;
    const double length = std::sqrt(quotient(length2, unit2 * unit2));
    const double sine_gap = quotient(gap, unit2 * unit * lengths_.factor());
    result_.gap = std::max(result_.gap, sine_gap / length);
    result_.sine_gap = std::max(result_.sine_gap, is_face ? sine_gap / length : sine_gap);
  }

  CommonFactor lengths_, directions_;
  Integer between_, half_a_, half_b_;
  std::array<Integer, 3> axis_a_, axis_b_;
  Separation result_{false, -HUGE_VAL, -HUGE_VAL};
};

}  // namespace

Separation separation(const Obb& box_a, const Obb& box_b, Reading read_a, Reading read_b) {
  return Axes(exactly(box_a, read_a), exactly(box_b, read_b)).separation();
}

Separation separation(const Aabb& aligned, const Obb& oriented, Reading read) {
  return Axes(exactly(aligned), exactly(oriented, read)).separation();
}

}  // namespace graze::oracle
