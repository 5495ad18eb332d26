#include <tests/oracle/category.h>

// Triangles that touch a face, an edge or a corner of a box from outside, exactly (on integers) or
// within a few ulps.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

// A box with one of its corners singled out.
struct Cornered {
  Aabb box;
  Vector3d corner;
  Vector3d outward;  // the signs of the way out at the corner
};

Cornered cornered(const Vector3d& corner, const Vector3d& outward, const Vector3d& size) {
  return {box_between(corner, corner - outward.cwiseProduct(size)), corner, outward};
}

Vector3d signs(Sampler& s) {
  return {s.sign(), s.sign(), s.sign()};
}

Cornered whole_cornered(Sampler& s) {
  const Vector3d corner = s.whole_point(100);
  const Vector3d outward = signs(s);
  const Vector3d size{double(s.integer(0, 50)), double(s.integer(0, 50)), double(s.integer(0, 50))};
  return cornered(corner, outward, size);
}

Cornered any_cornered(Sampler& s) {
  const Vector3d corner = s.point();
  const Vector3d outward = signs(s);
  return cornered(corner, outward, s.point().cwiseAbs());
}

// A vertex on the face x = corner.x, the others beyond it; a step or an ulp decides.
TriangleAndBox vertex_on_face(Sampler& s) {
  const Cornered c = whole_cornered(s);
  const double step = s.integer(-1, 1);
  const auto beyond = [&](double distance) {
    const Vector3d p = c.corner - 20 * c.outward + s.whole_point(30);
    return Vector3d(c.corner.x() + c.outward.x() * distance, p.y(), p.z());
  };
  const Triangle t{beyond(step), beyond(s.integer(1, 9)), beyond(s.integer(1, 9))};
  return turned(s, TriangleAndBox{s.shuffled(t), c.box});
}

TriangleAndBox vertex_on_face_by_ulps(Sampler& s) {
  const Cornered c = any_cornered(s);
  const auto beyond = [&](double x) {
    const Vector3d p = c.corner - 0.4 * c.outward + 0.5 * s.point();
    return Vector3d(x, p.y(), p.z());
  };
  const double far_x = c.corner.x() + c.outward.x();
  const Triangle t{beyond(s.nudged(c.corner.x(), 2)), beyond(far_x), beyond(far_x)};
  return turned(s, TriangleAndBox{s.shuffled(t), c.box});
}

// Parallel to a face, in its plane or a step off.
TriangleAndBox face_in_plane(Sampler& s) {
  const Cornered c = whole_cornered(s);
  const double x = c.corner.x() + c.outward.x() * s.integer(0, 1);
  const auto vertex = [&] {
    const Vector3d p = c.corner - 25 * c.outward + s.whole_point(60);
    return Vector3d(x, p.y(), p.z());
  };
  const Triangle t{vertex(), vertex(), vertex()};
  return turned(s, TriangleAndBox{t, c.box});
}

// The plane of the triangle holds the corner and nothing else of the box; `u` and `v` span it.
struct Tangent {
  Vector3d u;
  Vector3d v;
};

// n has the signs of `outward`; u and v are at right angles to it, exactly for small integers.
Tangent tangent(const Vector3d& n) {
  return {Vector3d(n.y(), -n.x(), 0), Vector3d(0, n.z(), -n.y())};
}

// Weights (1, 1), (-2, 1), (0, -2) around the corner: it is inside; shifted by `off` it may not be.
Triangle around(const Vector3d& corner, const Tangent& plane, double off_u, double off_v) {
  const auto at = [&](double i, double j) {
    return Vector3d(corner + (i + off_u) * plane.u + (j + off_v) * plane.v);
  };
  return {at(1, 1), at(-2, 1), at(0, -2)};
}

TriangleAndBox plane_at_corner(Sampler& s) {
  const Cornered c = whole_cornered(s);
  const Vector3d lengths{double(s.integer(1, 9)), double(s.integer(1, 9)), double(s.integer(1, 9))};
  const Tangent plane = tangent(c.outward.cwiseProduct(lengths));
  const double off_u = s.integer(-1, 1);
  const Triangle t = around(c.corner, plane, off_u, s.integer(-1, 1));
  const Vector3d shift = s.one_in(2) ? Vector3d(Vector3d::Zero()) : s.whole_point(1);
  return {s.shuffled(moved(t, shift)), c.box};
}

TriangleAndBox plane_at_corner_by_ulps(Sampler& s) {
  const Cornered c = any_cornered(s);
  const Vector3d lengths = s.point().cwiseAbs();
  const Tangent plane = tangent(c.outward.cwiseProduct(lengths));
  const Triangle t = around(c.corner, plane, s.symmetric() / 2, 0);
  return {s.shuffled(s.nudged(t, 1)), c.box};
}

// The box edge through the corner along z; a triangle's edge crosses it from outside.
TriangleAndBox edge_on_edge(const Cornered& c, double along, double slope, double rise) {
  const Vector3d contact = c.corner - along * Vector3d(0, 0, c.outward.z());
  const Vector3d across(c.outward.x(), -slope * c.outward.y(), rise);
  const Vector3d out(c.outward.x(), c.outward.y(), 0);
  return {{contact + across, contact - 2 * across, contact + 3 * out}, c.box};
}

TriangleAndBox edge_on_edge_whole(Sampler& s) {
  const Cornered c = whole_cornered(s);
  const double along = s.integer(-5, 20);
  const double slope = s.integer(1, 5);
  TriangleAndBox pair = edge_on_edge(c, along, slope, s.integer(-5, 5));
  if (s.one_in(2)) pair.triangle = moved(pair.triangle, s.whole_point(1));
  pair.triangle = s.shuffled(pair.triangle);
  return turned(s, pair);
}

TriangleAndBox edge_on_edge_by_ulps(Sampler& s) {
  const Cornered c = any_cornered(s);
  const double along = s.unit() * (c.box.max.z() - c.box.min.z());
  const double slope = s.magnitude(-3, 3);
  TriangleAndBox pair = edge_on_edge(c, along, slope, s.symmetric());
  pair.triangle = s.shuffled(s.nudged(pair.triangle, 1));
  return turned(s, pair);
}

// A vertex at a corner, the triangle beyond it.
TriangleAndBox vertex_at_corner_by_ulps(Sampler& s) {
  const Cornered c = any_cornered(s);
  const auto beyond = [&] { return Vector3d(c.corner + c.outward + s.point()); };
  const Vector3d vertex = s.nudged(c.corner, s.one_in(3) ? 0 : 1);
  return {s.shuffled({vertex, beyond(), beyond()}), c.box};
}

}  // namespace

void add_touching_boxes(std::vector<BoxCategory>& categories) {
  categories.push_back({"vertex_on_face", vertex_on_face});
  categories.push_back({"vertex_on_face_by_ulps", vertex_on_face_by_ulps});
  categories.push_back({"face_in_plane", face_in_plane});
  categories.push_back({"plane_at_corner", plane_at_corner});
  categories.push_back({"plane_at_corner_by_ulps", plane_at_corner_by_ulps});
  categories.push_back({"edge_on_edge", edge_on_edge_whole});
  categories.push_back({"edge_on_edge_by_ulps", edge_on_edge_by_ulps});
  categories.push_back({"vertex_at_corner_by_ulps", vertex_at_corner_by_ulps});
}

}  // namespace graze::oracle
