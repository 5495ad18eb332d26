#include <tests/oracle/category.h>

// Small integers, boxes without extent in one, two or three axes, and degenerate triangles.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

Aabb whole_box(Sampler& s, int reach) {
  const Vector3d p = s.whole_point(reach);
  return box_between(p, s.whole_point(reach));
}

TriangleAndBox tiny(Sampler& s) {
  return {s.whole_triangle(2), whole_box(s, 1)};
}
TriangleAndBox small(Sampler& s) {
  return {s.whole_triangle(5), whole_box(s, 3)};
}
TriangleAndBox large(Sampler& s) {
  return {s.whole_triangle(1 << 20), whole_box(s, 1 << 19)};
}

// The extent is zero in as many axes.
Aabb flattened(Sampler& s, Aabb box, int axes) {
  const int first = s.integer(0, 2);
  for (int k = 0; k < axes; ++k)
    box.max[(first + k) % 3] = box.min[(first + k) % 3];
  return box;
}

// Flat boxes with a vertex that the triangle's plane mostly holds exactly.
TriangleAndBox flat(Sampler& s, int axes) {
  const Triangle t = s.whole_triangle(3);
  const Vector3d p = t.a + s.integer(-1, 2) * (t.b - t.a);
  const Vector3d beside = s.one_in(2) ? Vector3d(Vector3d::Zero()) : s.whole_point(1);
  const Aabb box = box_between(p + beside, p + beside + s.whole_point(3));
  return {s.shuffled(t), flattened(s, box, axes)};
}

TriangleAndBox flat_in_one(Sampler& s) {
  return flat(s, 1);
}
TriangleAndBox flat_in_two(Sampler& s) {
  return flat(s, 2);
}

// The box is a point: on the triangle at weights in quarters, or a step beside it.
TriangleAndBox flat_in_three(Sampler& s) {
  const Triangle t = scaled(s.whole_triangle(4), 4);
  const int i = s.integer(0, 4);
  const Vector3d on_triangle = point_at(t, i / 4.0, s.integer(0, 4 - i) / 4.0);
  const Vector3d p = s.one_in(2) ? on_triangle : Vector3d(on_triangle + s.whole_point(1));
  return {t, {p, p}};
}

// Without exactness: the flat box cuts the triangle's surface within ulps.
TriangleAndBox flat_by_ulps(Sampler& s) {
  const Triangle t = s.triangle();
  const Vector3d p = s.nudged(s.one_in(2) ? point_at(t, s.unit(), 0) : s.point_in(t), 1);
  const int axes = s.integer(1, 3);
  const double size = s.magnitude(-54, 0);
  return {t, flattened(s, box_between(p, p + size * s.point()), axes)};
}

TriangleAndBox segment(Sampler& s) {
  const Vector3d p = s.whole_point(5);
  const Vector3d q = s.whole_point(5);
  const Triangle t{p, q, s.one_in(2) ? q : Vector3d(q + s.integer(-2, 2) * (q - p))};
  return {s.shuffled(t), whole_box(s, 3)};
}

TriangleAndBox point(Sampler& s) {
  const Aabb box = whole_box(s, 3);
  const Vector3d p = s.whole_point(3);
  return {{p, p, p}, box};
}

// A segment that passes a box edge or corner within ulps.
TriangleAndBox segment_by_ulps(Sampler& s) {
  const Vector3d p = s.point();
  const Aabb box = box_between(p, s.point());
  const std::array<Vector3d, 8> all = corners(box);
  const auto k = static_cast<std::size_t>(s.integer(0, 7));
  const Vector3d target = all[k] + s.unit() * (all[k ^ 1] - all[k]);
  const Vector3d axis = s.point();
  const Vector3d from = s.nudged(target + axis, 1);
  const Vector3d to = s.one_in(2) ? s.nudged(target, 1) : Vector3d(target - axis);
  return {s.shuffled({from, to, s.one_in(2) ? from : to}), box};
}

}  // namespace

void add_lattice_boxes(std::vector<BoxCategory>& categories) {
  categories.push_back({"lattice_tiny", tiny});
  categories.push_back({"lattice_small", small});
  categories.push_back({"lattice_large", large});
  categories.push_back({"flat_in_one_axis", flat_in_one});
  categories.push_back({"flat_in_two_axes", flat_in_two});
  categories.push_back({"flat_in_three_axes", flat_in_three});
  categories.push_back({"flat_by_ulps", flat_by_ulps});
  categories.push_back({"degenerate_segment", segment});
  categories.push_back({"degenerate_point", point});
  categories.push_back({"degenerate_segment_by_ulps", segment_by_ulps});
}

}  // namespace graze::oracle
