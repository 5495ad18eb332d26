#include "tests/narrowphase/motion/random_paths.h"

#include <cmath>

namespace graze::tests {
namespace {

PathQuery on_lattice(RandomSource& source, int reach) {
  PathQuery query;
  for (PointPath& path : query.path)
    path = {source.lattice_point(-reach, reach), source.lattice_point(-reach, reach)};
  return query;
}

PathQuery generic(RandomSource& source) {
  PathQuery query;
  for (PointPath& path : query.path)
    path = {source.vector(-1, 1), source.vector(-1, 1)};
  return query;
}

/// Any finite double.
double any_double(RandomSource& source) {
  const double size = source.uniform_at_scale(0.5, 1, -1073, 1024);
  return source.integer(0, 1) != 0 ? size : -size;
}

/// All in the plane z = x, or on the line in it.
PathQuery flattened(PathQuery query, bool is_on_line) {
  for (PointPath& path : query.path) {
    for (Eigen::Vector3d* p : {&path.start, &path.end})
      *p = {p->x(), is_on_line ? -p->x() : p->y(), p->x()};
  }
  return query;
}

PathQuery scaled(PathQuery query, int exponent) {
  for (PointPath& path : query.path) {
    for (Eigen::Vector3d* p : {&path.start, &path.end}) {
      for (int k = 0; k < 3; ++k)
        p->data()[k] = std::ldexp(p->data()[k], exponent);
    }
  }
  return query;
}

/// A few paths stand still, are those of others, or move as others do.
PathQuery with_ties(PathQuery query, RandomSource& source) {
  for (int i = 0; i < 4; ++i) {
    PointPath& path = query.path[i];
    const PointPath& other = query.path[static_cast<int>(source.integer(0, 3))];
    switch (static_cast<int>(source.integer(0, 7))) {
      case 0:
        path.end = path.start;
        break;
      case 1:
        path = other;
        break;
      case 2:
        path.end = path.start + (other.end - other.start);
        break;
      case 3:
        path.end = other.end;
        break;
      case 4:
        path.start = other.start;
        break;
      default:
        break;
    }
  }
  return query;
}

/// The triangle keeps its plane z = 0, and the point comes down to it and goes up again, as the
/// triangle's own plane moves: touching at a time t = m / 8 without going through. The height of
/// the point over the plane is (8 t - m)^2, made of a plane that tilts.
PathQuery touching(RandomSource& source) {
  const double m = source.integer(0, 8);
  // The normal turns as (1, 0, t'), the point moves as (t' a, 0, b t' ...): n . p = t'^2.
  const auto at = [&](double t, double x, double z) { return Eigen::Vector3d(x * t, 0, z); };
  const double u = -m / 8, v = 1 - m / 8;
  PathQuery query;
  // The plane holds the y-axis and (1, 0, t'); the point is at (t', 0, 0).
  query.path[0] = {at(u, 1, 0), at(v, 1, 0)};
  const double reach = source.integer(1, 4), y = source.integer(-2, 2);
  query.path[1] = {{-reach, y, -reach * u}, {-reach, y, -reach * v}};
  query.path[2] = {{reach, -3, reach * u}, {reach, -3, reach * v}};
  query.path[3] = {{reach, 3, reach * u}, {reach, 3, reach * v}};
  return query;
}

}  // namespace

const char* name_of_path_kind(int kind) {
  static constexpr const char* kNames[kPathKinds] = {"generic",
                                                     "small lattice",
                                                     "tiny lattice",
                                                     "ties",
                                                     "generic ties",
                                                     "flat",
                                                     "flat ties",
                                                     "flat generic",
                                                     "on a line",
                                                     "touching",
                                                     "any double",
                                                     "huge and tiny coordinates",
                                                     "lattice at 2^+-900",
                                                     "nearly flat"};
  return kNames[kind];
}

PathQuery random_paths(int kind, RandomSource& source) {
  switch (kind) {
    case 0:
      return generic(source);
    case 1:
      return on_lattice(source, 3);
    case 2:
      return on_lattice(source, 1);
    case 3:
      return with_ties(on_lattice(source, 2), source);
    case 4:
      return with_ties(generic(source), source);
    case 5:
      return flattened(on_lattice(source, 3), false);
    case 6:
      return with_ties(flattened(on_lattice(source, 2), false), source);
    case 7:
      return flattened(generic(source), false);
    case 8:
      return flattened(with_ties(on_lattice(source, 3), source), true);
    case 9:
      return touching(source);
    case 10: {
      PathQuery query;
      for (PointPath& path : query.path) {
        for (int k = 0; k < 3; ++k) {
          path.start.data()[k] = any_double(source);
          path.end.data()[k] = any_double(source);
        }
      }
      return query;
    }
    case 11: {
      PathQuery query = on_lattice(source, 2);
      for (PointPath& path : query.path) {
        for (Eigen::Vector3d* p : {&path.start, &path.end}) {
          double& x = p->data()[static_cast<int>(source.integer(0, 2))];
          x = std::ldexp(x, static_cast<int>(source.integer(-1, 1)) * 900);
        }
      }
      return query;
    }
    case 12: {
      const auto ties = with_ties(on_lattice(source, 3), source);
      return scaled(ties, source.integer(0, 1) != 0 ? 900 : -900);
    }
    default: {
      PathQuery query = flattened(with_ties(on_lattice(source, 3), source), false);
      double& x = query.path[static_cast<int>(source.integer(0, 3))].start.z();
      x = std::nextafter(x, source.integer(-1, 1) * 9);
      return query;
    }
  }
}

}  // namespace graze::tests
