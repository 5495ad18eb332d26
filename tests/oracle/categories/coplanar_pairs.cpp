#include <tests/oracle/category.h>

// Two triangles in exactly one plane: overlapping, touching within it, and apart.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

// Integer points origin + i u + j v, all far below 2^24: exact in double and in float.
struct Step {
  int i;
  int j;
};

struct LatticePlane {
  Vector3d origin;
  Vector3d u;
  Vector3d v;

  LatticePlane(Sampler& s, int reach)
      : origin(s.whole_point(8 * reach)), u(s.whole_point(reach)), v(s.whole_point(reach)) {}

  Vector3d at(Step step) const { return origin + step.i * u + step.j * v; }

  Triangle triangle(Sampler& s, int reach) const {
    Vector3d p[3];
    for (Vector3d& vertex : p)
      vertex = at({s.integer(-reach, reach), s.integer(-reach, reach)});
    return {p[0], p[1], p[2]};
  }
};

TrianglePair axis_plane(Sampler& s) {
  const double height = s.symmetric();
  const auto flat = [&](const Vector3d& p) { return Vector3d(p.x(), p.y(), height); };
  const Triangle a = for_each_vertex(s.triangle(), flat);
  const Triangle b = for_each_vertex(s.triangle(), flat);
  return turned(s, TrianglePair{a, b});
}

TrianglePair small_lattice(Sampler& s) {
  const LatticePlane plane(s, 3);
  const Triangle a = plane.triangle(s, 3);
  return {a, plane.triangle(s, 3)};
}

TrianglePair large_lattice(Sampler& s) {
  const LatticePlane plane(s, 1000);
  const Triangle a = plane.triangle(s, 1000);
  return {a, plane.triangle(s, 1000)};
}

// A vertex of B on an edge of A, or one step of the lattice beside it; the rest of B lies across.
TrianglePair vertex_at_edge(Sampler& s) {
  const LatticePlane plane(s, 50);
  const int i = 2 * s.integer(1, 100);
  const int j = 2 * s.integer(1, 100);
  const Triangle a{plane.at({0, 0}), plane.at({i, j}), plane.at({-j - s.integer(0, 40), i})};
  // Seen in the lattice, (j, -i) points across the edge from (0, 0) to (i, j), away from A.
  const int out = s.integer(-1, 1);
  const int x = i / 2 + (i > j ? 0 : out);
  const int y = j / 2 - (i > j ? out : 0);
  const int reach = s.integer(1, 3);
  const Vector3d foot = plane.at({x, y});
  const Triangle b{foot, plane.at({x + reach * j + s.integer(-5, 5), y - reach * i}),
                   plane.at({x + reach * j, y - reach * i + s.integer(-5, 5)})};
  return {s.shuffled(a), s.shuffled(b)};
}

// An edge of B on the line of an edge of A, apart, touching in a point, or overlapping in part.
TrianglePair edge_along_edge(Sampler& s) {
  const LatticePlane plane(s, 100);
  const int length = s.integer(1, 20);
  const int from = s.integer(-5, length + 5);
  const int to = from + s.integer(1, 20);
  const Triangle a{plane.at({0, 0}), plane.at({length, 0}),
                   plane.at({s.integer(-9, 9), s.integer(1, 9)})};
  const Triangle b{plane.at({from, 0}), plane.at({to, 0}),
                   plane.at({s.integer(-9, 9), -s.integer(1, 9)})};
  return {s.shuffled(a), s.shuffled(b)};
}

// Vertex against edge within an axis-parallel plane, by ulps.
TrianglePair vertex_at_edge_by_ulps(Sampler& s) {
  const double height = s.symmetric();
  const auto flat = [&](const Vector3d& p) { return Vector3d(p.x(), p.y(), height); };
  const Vector3d p = flat(s.point());
  const Vector3d edge = s.point();
  const Vector3d out(edge.y(), -edge.x(), 0);
  const auto across = [&](double distance) {
    return flat(p + distance * out + s.symmetric() * edge);
  };
  const Vector3d foot = s.nudged(p + s.unit() * edge, 2);
  const Triangle a{p, flat(p + edge), across(-1)};
  const Triangle b{flat(foot), across(1), across(1.5)};
  return turned(s, TrianglePair{s.shuffled(a), s.shuffled(b)});
}

// One within the other, at times by a hair.
TrianglePair nested(Sampler& s) {
  const LatticePlane plane(s, 100);
  const Triangle a{plane.at({0, 0}), plane.at({40, 0}), plane.at({0, 40})};
  const int i = s.integer(-3, 25);
  const int j = s.integer(-3, 25);
  const Triangle b{plane.at({i, j}), plane.at({i + s.integer(1, 3), j}),
                   plane.at({i, j + s.integer(1, 3)})};
  return s.one_in(2) ? TrianglePair{s.shuffled(a), s.shuffled(b)}
                     : TrianglePair{s.shuffled(b), s.shuffled(a)};
}

}  // namespace

void add_coplanar_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"coplanar_axis_plane", axis_plane});
  categories.push_back({"coplanar_small_lattice", small_lattice});
  categories.push_back({"coplanar_large_lattice", large_lattice});
  categories.push_back({"coplanar_vertex_at_edge", vertex_at_edge});
  categories.push_back({"coplanar_edge_along_edge", edge_along_edge});
  categories.push_back({"coplanar_vertex_at_edge_by_ulps", vertex_at_edge_by_ulps});
  categories.push_back({"coplanar_nested", nested});
}

}  // namespace graze::oracle
