#include <graze/engine/compare/referee.h>
#include <tests/oracle/bisection.h>
#include <tests/oracle/category.h>

// Pairs in general position, moved to within rounding of the place where the answer changes.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

template <typename Make>
TrianglePair at_flip(Sampler& s, Make make) {
  const double t = near_flip(s, make, [](const TrianglePair& pair) {
    return compare::referee_intersects(pair.a, pair.b);
  });
  return make(t);
}

Vector3d rounded(const Sampler& s, const Vector3d& p) {
  return {on_grid(p.x(), s.grid()), on_grid(p.y(), s.grid()), on_grid(p.z(), s.grid())};
}

Triangle rounded(const Sampler& s, const Triangle& t) {
  return for_each_vertex(t, [&](const Vector3d& p) { return rounded(s, p); });
}

// B slides from a place where it touches A to one where it does not.
TrianglePair sliding(Sampler& s) {
  const Triangle a = rounded(s, s.triangle());
  const Triangle shape = s.triangle();
  const Vector3d touching = s.point_in(a) - shape.a;
  const Vector3d away = 4 * s.point();
  return at_flip(s, [&](double t) {
    return TrianglePair{a, rounded(s, moved(shape, touching + t * away))};
  });
}

// One vertex of B moves, so that mostly an edge of B comes to touch an edge or a vertex of A.
TrianglePair stretching(Sampler& s) {
  const Triangle a = rounded(s, s.triangle());
  const Triangle b = rounded(s, s.triangle());
  const Vector3d inside = s.point_in(a);
  const Vector3d target = inside + (inside - b.a);
  return at_flip(s, [&](double t) {
    return TrianglePair{a, {b.a, b.b, rounded(s, b.c + t * (target - b.c))}};
  });
}

// As sliding, in one axis-parallel plane: edge against vertex within it.
TrianglePair sliding_in_plane(Sampler& s) {
  const double height = on_grid(s.symmetric(), s.grid());
  const auto flat = [&](const Vector3d& p) { return rounded(s, Vector3d(p.x(), p.y(), height)); };
  const Triangle a = for_each_vertex(s.triangle(), flat);
  const Triangle shape = s.triangle();
  const Vector3d touching = s.point_in(a) - shape.a;
  const Vector3d away = 4 * s.point();
  const int turns = s.integer(0, 2);
  return at_flip(s, [&](double t) {
    const Triangle b = for_each_vertex(moved(shape, touching + t * away), flat);
    return turned(TrianglePair{a, b}, turns);
  });
}

}  // namespace

void add_bisected_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"bisected_sliding", sliding});
  categories.push_back({"bisected_stretching", stretching});
  categories.push_back({"bisected_in_plane", sliding_in_plane});
}

}  // namespace graze::oracle
