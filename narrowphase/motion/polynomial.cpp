#include <graze/narrowphase/motion/polynomial.h>

namespace graze::narrowphase {

Polynomial derivative(const Polynomial& f) {
  Polynomial result;
  BigInteger power = BigInteger::from_double(1, 0);
  const BigInteger one = power;
  for (int i = 1; i <= f.degree; ++i) {
    result.coefficient[i - 1] = f.coefficient[i] * power;
    power = power + one;
  }
  result.take(f.degree);
  return result;
}

Polynomial product(const LinearPath& a, const LinearPath& b) {
  Polynomial result;
  result.coefficient[0] = a.start * b.start;
  result.coefficient[1] = a.start * b.change + a.change * b.start;
  result.coefficient[2] = a.change * b.change;
  result.take(3);
  return result;
}

Polynomial difference_of_products(const LinearPath& a, const LinearPath& b, const LinearPath& c,
                                  const LinearPath& d) {
  Polynomial result;
  result.coefficient[0] = a.start * b.start - c.start * d.start;
  result.coefficient[1] =
      (a.start * b.change + a.change * b.start) - (c.start * d.change + c.change * d.start);
  result.coefficient[2] = a.change * b.change - c.change * d.change;
  result.take(3);
  return result;
}

Polynomial cross(const ExactPaths& paths, Offset a, Offset b, int axis) {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  return difference_of_products(paths.offset(a.from, a.to, next), paths.offset(b.from, b.to, last),
                                paths.offset(a.from, a.to, last), paths.offset(b.from, b.to, next));
}

Polynomial triple(const ExactPaths& paths, Offset a, Offset b, Offset c) {
  Polynomial result;
  for (int axis = 0; axis < 3; ++axis) {
    const Polynomial normal = cross(paths, a, b, axis);
    const LinearPath along = paths.offset(c.from, c.to, axis);
    for (int i = 0; i <= normal.degree; ++i) {
      const BigInteger& n = normal.coefficient[i];
      result.coefficient[i] = result.coefficient[i] + n * along.start;
      result.coefficient[i + 1] = result.coefficient[i + 1] + n * along.change;
    }
  }
  result.take(4);
  return result;
}

ExactPaths::ExactPaths(const FourPaths& paths) {
  for (int axis = 0; axis < 3; ++axis) {
    CommonUnit unit({});
    for (int i = 0; i < 4; ++i) {
      unit.include(paths.start[i] + axis, 1);
      unit.include(paths.end[i] + axis, 1);
    }
    for (int i = 0; i < 4; ++i) {
      LinearPath& path = coordinate_[i][axis];
      path.start = unit.of(paths.start[i][axis]);
      path.change = unit.of(paths.end[i][axis]) - path.start;
    }
  }
}

Polynomial volume_of(const ExactPaths& paths, PathPair kind) {
  return kind == PathPair::PointTriangle ? triple(paths, {1, 2}, {1, 3}, {1, 0})
                                         : triple(paths, {0, 1}, {2, 3}, {0, 2});
}

}  // namespace graze::narrowphase
