#include <tests/oracle/category.h>

// Triangles with vertices in common, as neighbours in a mesh have, and nearly in common.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

TrianglePair shared_vertex(Sampler& s) {
  const Triangle a = s.triangle();
  return {s.shuffled(a), s.shuffled({a.a, s.point(), s.point()})};
}

TrianglePair shared_vertex_on_lattice(Sampler& s) {
  const Triangle a = s.whole_triangle(3);
  return {s.shuffled(a), s.shuffled({a.a, s.whole_point(3), s.whole_point(3)})};
}

TrianglePair shared_edge(Sampler& s) {
  const Triangle a = s.triangle();
  return {s.shuffled(a), s.shuffled({a.b, a.a, s.point()})};
}

TrianglePair identical(Sampler& s) {
  const Triangle a = s.triangle();
  return {a, s.shuffled(a)};
}

// The vertex that is nearly shared is the only place where the two can meet: A lies behind it as
// seen along `out`, B before it.
TrianglePair nearly_shared_vertex(Sampler& s) {
  const Vector3d meeting = s.point();
  const Vector3d out = s.point();
  const auto beside = [&](double distance) {
    const Vector3d across = out.cross(s.point());
    return Vector3d(meeting + distance * out + across);
  };
  const Triangle a{meeting, beside(-1), beside(-0.5)};
  const Vector3d nearly = s.nudged(meeting, s.one_in(4) ? 0 : 1);
  return {s.shuffled(a), s.shuffled({nearly, beside(1), beside(0.5)})};
}

// A mesh edge with a crack: both ends may be off by an ulp.
TrianglePair nearly_shared_edge(Sampler& s) {
  const Vector3d p = s.point();
  const Vector3d q = s.point();
  const Vector3d out = s.point();
  const Triangle a{p, q, p - out};
  const Triangle b{s.nudged(p, s.one_in(2) ? 0 : 1), s.nudged(q, 1), q + out};
  return {s.shuffled(a), s.shuffled(b)};
}

// Two layers of the same surface, ulps apart.
TrianglePair nearly_identical(Sampler& s) {
  const Triangle a = s.triangle();
  return {a, s.shuffled(s.nudged(a, 1))};
}

}  // namespace

void add_shared_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"shared_vertex", shared_vertex, Answers::Intersects});
  categories.push_back({"shared_vertex_on_lattice", shared_vertex_on_lattice, Answers::Intersects});
  categories.push_back({"shared_edge", shared_edge, Answers::Intersects});
  categories.push_back({"identical", identical, Answers::Intersects});
  categories.push_back({"nearly_shared_vertex", nearly_shared_vertex});
  categories.push_back({"nearly_shared_edge", nearly_shared_edge});
  categories.push_back({"nearly_identical", nearly_identical});
}

}  // namespace graze::oracle
