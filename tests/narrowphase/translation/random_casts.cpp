#include "tests/narrowphase/translation/random_casts.h"

#include <cmath>

namespace graze::tests {
namespace {

Triangle triangle_from(const Eigen::Vector3d (&p)[3]) {
  return {p[0], p[1], p[2]};
}

CastQuery generic(RandomSource& source, double way) {
  Eigen::Vector3d p[6];
  for (Eigen::Vector3d& v : p)
    v = source.vector(-1, 1);
  const Eigen::Vector3d d = source.vector(-way, way);
  // Most are ahead of each other.
  for (int i = 3; i < 6; ++i)
    p[i] = p[i] - source.uniform(0, 0.5) * d;
  return {triangle_from({p[0], p[1], p[2]}), triangle_from({p[3], p[4], p[5]}), d};
}

CastQuery on_lattice(RandomSource& source, int reach) {
  Eigen::Vector3d p[7];
  for (Eigen::Vector3d& v : p)
    v = source.lattice_point(-reach, reach);
  return {{p[0], p[1], p[2]}, {p[3], p[4], p[5]}, 2 * p[6]};
}

double* coordinate_of(CastQuery& query, int point, int axis) {
  Eigen::Vector3d* points[7] = {&query.a.a, &query.a.b, &query.a.c,         &query.b.a,
                                &query.b.b, &query.b.c, &query.displacement};
  return points[point]->data() + axis;
}

/// All in one plane, or on one line in it.
CastQuery flattened(CastQuery query, bool is_on_line) {
  for (int i = 0; i < 7; ++i) {
    const double x = *coordinate_of(query, i, 0);
    *coordinate_of(query, i, 2) = x;
    if (is_on_line) *coordinate_of(query, i, 1) = -x;
  }
  return query;
}

CastQuery scaled(CastQuery query, const int (&exponent)[3]) {
  for (int i = 0; i < 7; ++i) {
    for (int k = 0; k < 3; ++k)
      *coordinate_of(query, i, k) = std::ldexp(*coordinate_of(query, i, k), exponent[k]);
  }
  return query;
}

/// B goes along an edge, into a corner, or as far as it takes to come to one.
CastQuery aimed(CastQuery query, RandomSource& source) {
  switch (static_cast<int>(source.integer(0, 4))) {
    case 0:
      query.displacement = query.a.a - query.b.b;
      break;
    case 1:
      query.displacement = 2 * (query.a.c - query.b.a);
      break;
    case 2:
      query.displacement = query.a.b - query.a.a;
      break;
    case 3:
      query.displacement = query.b.b - query.b.a;
      break;
    default:
      query.displacement = 0.5 * (query.a.a + query.a.b) - query.b.c;
  }
  return query;
}

/// Corners that coincide, or are in the middle of an edge.
CastQuery without_area(CastQuery query, RandomSource& source) {
  Triangle* const triangles[2] = {&query.a, &query.b};
  Triangle& t = *triangles[static_cast<int>(source.integer(0, 1))];
  switch (static_cast<int>(source.integer(0, 3))) {
    case 0:
      t.c = t.a;
      break;
    case 1:
      t.b = t.c = t.a;
      break;
    case 2:
      t.c = 0.5 * (t.a + t.b);
      break;
    default:
      query.a.c = query.a.a;
      query.b.c = query.b.b;
  }
  return query;
}

/// They have a corner, or an edge, in common at the start.
CastQuery touching(CastQuery query, RandomSource& source) {
  query.b.a = query.a.a;
  if (source.integer(0, 1) != 0) query.b.b = query.a.b;
  return query;
}

CastQuery needles(RandomSource& source) {
  CastQuery query = generic(source, 3);
  query.a.c = query.a.b + 0x1p-45 * source.vector(-1, 1);
  query.b.c = 0.5 * (query.b.a + query.b.b) + 0x1p-50 * source.vector(-1, 1);
  return aimed(query, source);
}

double any_double(RandomSource& source) {
  const double size = source.uniform_at_scale(0.5, 1, -1073, 1024);
  return source.integer(0, 1) != 0 ? size : -size;
}

}  // namespace

const char* name_of_cast_kind(int kind) {
  static constexpr const char* kNames[kCastKinds] = {
      "generic",     "long ways",     "a small lattice",    "a lattice",    "in one plane",
      "on one line", "aimed",         "aimed on a lattice", "without area", "touching at first",
      "needles",     "huge and tiny", "scales by axes",     "any double"};
  return kNames[kind];
}

CastQuery random_cast(int kind, RandomSource& source) {
  switch (kind) {
    case 0:
      return generic(source, 2);
    case 1:
      return generic(source, 100);
    case 2:
      return on_lattice(source, 1);
    case 3:
      return on_lattice(source, 3);
    case 4:
      return flattened(source.integer(0, 1) != 0 ? on_lattice(source, 3) : generic(source, 3),
                       false);
    case 5:
      return flattened(on_lattice(source, 4), true);
    case 6:
      return aimed(generic(source, 1), source);
    case 7:
      return aimed(on_lattice(source, 4), source);
    case 8:
      return without_area(source.integer(0, 1) != 0 ? on_lattice(source, 2) : generic(source, 3),
                          source);
    case 9:
      return touching(source.integer(0, 1) != 0 ? on_lattice(source, 2) : generic(source, 2),
                      source);
    case 10:
      return needles(source);
    case 11: {
      const int exponent = source.integer(0, 1) != 0 ? 900 : -900;
      return scaled(
          source.integer(0, 1) != 0 ? aimed(on_lattice(source, 4), source) : generic(source, 3),
          {exponent, exponent, exponent});
    }
    case 12: {
      const auto path = source.integer(0, 1) != 0 ? on_lattice(source, 3) : generic(source, 3);
      return scaled(path, {static_cast<int>(source.integer(-900, 900)),
                           static_cast<int>(source.integer(-900, 900)),
                           static_cast<int>(source.integer(-900, 900))});
    }
    default: {
      CastQuery query = generic(source, 2);
      for (int i = 0; i < 7; ++i) {
        for (int k = 0; k < 3; ++k) {
          if (source.integer(0, 3) == 0) *coordinate_of(query, i, k) = any_double(source);
        }
      }
      return query;
    }
  }
}

}  // namespace graze::tests
