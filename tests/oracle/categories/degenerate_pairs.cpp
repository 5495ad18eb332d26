#include <tests/oracle/category.h>

// Triangles of exactly zero area: segments (a repeated vertex, or three collinear ones) and points,
// against triangles and against each other. Small integers, so that "exactly" holds.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

// The segment from p to q; all three vertices on it.
Triangle segment(Sampler& s, const Vector3d& p, const Vector3d& q) {
  if (s.one_in(2)) return s.shuffled({p, q, s.one_in(2) ? p : q});
  const Vector3d step = q - p;  // the ends move outward by whole steps: collinear without rounding
  return s.shuffled({p, q + s.integer(0, 2) * step, q});
}

Triangle segment_through(Sampler& s, const Vector3d& p, const Vector3d& step) {
  const Vector3d from = p - s.integer(0, 3) * step;
  return segment(s, from, p + s.integer(1, 3) * step);
}

Triangle point(const Vector3d& p) {
  return {p, p, p};
}

// A lattice point of A's inside or border, or one beside it.
Vector3d target_on(Sampler& s, const Triangle& a) {
  const int i = s.integer(0, 4);
  const int j = s.integer(0, 4 - i);
  const Vector3d exact = point_at(a, i / 4.0, j / 4.0);
  return s.one_in(2) ? exact : Vector3d(exact + s.whole_point(1));
}

Triangle quarters(Sampler& s) {
  return scaled(s.whole_triangle(5), 4);
}

TrianglePair segment_triangle(Sampler& s) {
  const Triangle a = quarters(s);
  const Vector3d target = target_on(s, a);
  return {a, segment_through(s, target, s.whole_point(6))};
}

// The segment lies in the triangle's plane.
TrianglePair segment_in_plane(Sampler& s) {
  const Triangle a = s.whole_triangle(5);
  const auto in_plane = [&] {
    const int i = s.integer(-2, 3);
    return Vector3d(a.a + i * (a.b - a.a) + s.integer(-2, 3) * (a.c - a.a));
  };
  const Vector3d p = in_plane();
  return {s.shuffled(a), segment(s, p, in_plane())};
}

TrianglePair segment_segment(Sampler& s) {
  const Vector3d meeting = s.whole_point(4);
  const Vector3d beside = s.one_in(2) ? Vector3d(Vector3d::Zero()) : s.whole_point(1);
  const Triangle a = segment_through(s, meeting, s.whole_point(3));
  return {a, segment_through(s, meeting + beside, s.whole_point(3))};
}

TrianglePair collinear_segments(Sampler& s) {
  const Vector3d origin = s.whole_point(4);
  const Vector3d step = s.whole_point(3);
  const auto piece = [&](const Vector3d& start) {
    const Vector3d p = start + s.integer(-5, 5) * step;
    return segment(s, p, start + s.integer(-5, 5) * step);
  };
  const Triangle a = piece(origin);
  return {a, piece(s.one_in(4) ? Vector3d(origin + s.whole_point(1)) : origin)};
}

TrianglePair point_triangle(Sampler& s) {
  const Triangle a = quarters(s);
  return {a, point(target_on(s, a))};
}

TrianglePair point_segment(Sampler& s) {
  const Vector3d p = s.whole_point(4);
  const Triangle a = segment_through(s, p, 2 * s.whole_point(2));
  return {a, point(target_on(s, {p, a.a, a.b}))};
}

TrianglePair point_point(Sampler& s) {
  const Vector3d p = s.point();
  return {point(p), point(s.one_in(2) ? p : s.nudged(p, 1))};
}

// Collinear up to the rounding of one vertex, and meeting a triangle near an edge.
TrianglePair nearly_segment(Sampler& s) {
  const Triangle a = s.triangle();
  const Vector3d target = s.nudged(point_at(a, s.unit(), 0), 2);
  const Vector3d axis = s.point();
  const Vector3d p = target - s.unit() * axis;
  const Vector3d q = target + s.unit() * axis;
  return {s.shuffled(a), s.shuffled({p, q, s.one_in(2) ? target : p})};
}

// A segment from exactly the vertex of the other, or from an ulp beside it.
TrianglePair segment_at_vertex(Sampler& s) {
  const Triangle a = s.triangle();
  const Vector3d away = a.a + (a.a - (a.b + a.c) / 2);
  const Vector3d start = s.nudged(a.a, s.one_in(2) ? 0 : 1);
  return {s.shuffled(a), s.shuffled({start, away, s.one_in(2) ? start : away})};
}

// Every shape against every other on a tiny lattice.
TrianglePair anything(Sampler& s) {
  const auto shape = [&] {
    const Vector3d p = s.whole_point(2);
    const int kind = s.integer(0, 2);
    if (kind == 0) return point(p);
    return kind == 1 ? segment(s, p, s.whole_point(2))
                     : Triangle{p, s.whole_point(2), s.whole_point(2)};
  };
  const Triangle a = shape();
  return {a, shape()};
}

}  // namespace

void add_degenerate_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"degenerate_segment_triangle", segment_triangle});
  categories.push_back({"degenerate_segment_in_plane", segment_in_plane});
  categories.push_back({"degenerate_segment_segment", segment_segment});
  categories.push_back({"degenerate_collinear_segments", collinear_segments});
  categories.push_back({"degenerate_point_triangle", point_triangle});
  categories.push_back({"degenerate_point_segment", point_segment});
  categories.push_back({"degenerate_point_point", point_point});
  categories.push_back({"degenerate_nearly_segment", nearly_segment});
  categories.push_back({"degenerate_segment_at_vertex", segment_at_vertex});
  categories.push_back({"degenerate_anything", anything});
}

}  // namespace graze::oracle
