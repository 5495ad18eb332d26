#include <tests/oracle/category.h>

// Pairs that touch in one point, and pairs that would but for one step of the lattice or a few
// ulps. A lies behind the point of contact, B before it, so that this step decides.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

// Multiples of 8, so that points with weights in eighths are integers.
Triangle eighths(Sampler& s) {
  return scaled(s.whole_triangle(100), 8);
}

// The point of A with positive weights i/8, j/8 and the rest.
Vector3d inner_point(Sampler& s, const Triangle& a) {
  const int i = s.integer(1, 6);
  const int j = s.integer(1, 7 - i);
  return point_at(a, i / 8.0, j / 8.0);
}

Vector3d normal_of(const Triangle& t) {
  return (t.b - t.a).cross(t.c - t.a);
}

// A shift by one step along the main axis of `out`, or none, or one back.
Vector3d whole_shift(Sampler& s, const Vector3d& out) {
  Vector3d shift = Vector3d::Zero();
  Eigen::Index axis = 0;
  out.cwiseAbs().maxCoeff(&axis);
  shift[axis] = (out[axis] < 0 ? -1 : 1) * s.integer(-1, 1);
  return shift;
}

// B's first vertex lies at `contact`; the others before it, along `out` (of the length of B).
Triangle before(Sampler& s, const Vector3d& contact, const Vector3d& out) {
  const Vector3d b = contact + out + s.whole_point(20);
  return {contact, b, contact + out + s.whole_point(20)};
}

Vector3d whole_direction(const Vector3d& v, double length) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (largest == 0) return {0, 0, length};
  return (v * (length / largest)).array().round().matrix();
}

TrianglePair vertex_on_face(Sampler& s) {
  const Triangle a = eighths(s);
  const Vector3d out = whole_direction(normal_of(a), 500);
  const Triangle b = before(s, inner_point(s, a), out);
  return {s.shuffled(a), s.shuffled(moved(b, whole_shift(s, out)))};
}

// Away from the edge within A's plane, or nearly.
TrianglePair vertex_on_edge(Sampler& s) {
  const Triangle a = eighths(s);
  const Vector3d contact = point_at(a, s.integer(1, 7) / 8.0, 0);
  const Vector3d out = whole_direction((a.b - a.a).cross(normal_of(a)), 500);
  const Triangle b = before(s, contact, out);
  return {s.shuffled(a), s.shuffled(moved(b, whole_shift(s, out)))};
}

// Two edges cross at a point with weights in eighths on both; the third vertices lie on the two
// sides of the plane that the edges span.
TrianglePair edge_across_edge(Sampler& s) {
  const Vector3d contact = s.whole_point(100);
  const Vector3d u = s.whole_point(50);
  const Vector3d v = s.whole_point(50);
  const Vector3d out = whole_direction(u.cross(v), 500);
  const Triangle a{contact + s.integer(1, 7) * u, contact - s.integer(1, 7) * u, contact - out};
  const Triangle b{contact + s.integer(1, 7) * v, contact - s.integer(1, 7) * v, contact + out};
  return {s.shuffled(a), s.shuffled(moved(b, whole_shift(s, out)))};
}

TrianglePair vertex_on_face_by_ulps(Sampler& s) {
  const Triangle a = s.triangle();
  const Vector3d out = normal_of(a);
  const Vector3d contact = s.point_in(a);
  const auto beyond = [&] { return Vector3d(contact + out + 0.1 * out.cross(s.point())); };
  return {a, s.shuffled({s.nudged(contact, 2), beyond(), beyond()})};
}

// B stands upright on A's plane, its tip at an edge of A: how far the tip reaches decides.
TrianglePair vertex_on_edge_by_ulps(Sampler& s) {
  const Triangle a = s.triangle();
  const Vector3d normal = normal_of(a);
  const Vector3d out = (a.b - a.a).cross(normal);
  const Vector3d contact = point_at(a, s.unit(), 0);
  const auto beyond = [&](double height) {
    return Vector3d(contact + out + height * normal + 0.1 * out.cross(s.point()));
  };
  return {s.shuffled(a), s.shuffled({s.nudged(contact, 2), beyond(-1), beyond(1)})};
}

TrianglePair edge_across_edge_by_ulps(Sampler& s) {
  const Vector3d contact = s.point();
  const Vector3d u = s.point();
  const Vector3d v = s.point();
  const Vector3d out = u.cross(v);
  const Triangle a{contact + s.unit() * u, contact - s.unit() * u, contact - out};
  const Triangle b{contact + s.unit() * v, contact - s.unit() * v, contact + out};
  return {s.shuffled(a), s.shuffled(s.nudged(b, 1))};
}

// Faces of boxes that stand on each other, a step beside each other, or an ulp apart.
TrianglePair stacked(Sampler& s) {
  const double floor = s.symmetric();
  const auto corner = [&](double x, double y, bool is_up) {
    const double z = s.one_in(4) ? s.nudged(floor, 1) : floor;
    return Vector3d(x, y, is_up ? z + 1 : z);
  };
  const double x = s.integer(-4, 4) / 4.0;
  const double y = s.integer(-4, 4) / 4.0;
  const Triangle lid{corner(0, 0, false), corner(1, 0, false), corner(1, 1, false)};
  const bool is_wall = s.one_in(2);
  const Triangle b{corner(x, y, false), corner(x + 1, y, false),
                   is_wall ? corner(x + 1, y, true) : corner(x, y + 1, false)};
  return turned(s, TrianglePair{s.shuffled(lid), s.shuffled(b)});
}

}  // namespace

void add_touching_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"vertex_on_face", vertex_on_face});
  categories.push_back({"vertex_on_edge", vertex_on_edge});
  categories.push_back({"edge_across_edge", edge_across_edge});
  categories.push_back({"vertex_on_face_by_ulps", vertex_on_face_by_ulps});
  categories.push_back({"vertex_on_edge_by_ulps", vertex_on_edge_by_ulps});
  categories.push_back({"edge_across_edge_by_ulps", edge_across_edge_by_ulps});
  categories.push_back({"stacked", stacked});
}

}  // namespace graze::oracle
