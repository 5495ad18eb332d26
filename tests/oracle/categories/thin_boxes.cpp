#include <tests/oracle/category.h>

// Needles and caps against boxes, and boxes as thin as needles.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

Aabb any_box(Sampler& s) {
  const Vector3d p = s.point();
  return box_between(p, s.point());
}

// A point on the box edge between two corners that differ in one axis.
Vector3d point_on_edge(Sampler& s, const Aabb& box) {
  const std::array<Vector3d, 8> all = corners(box);
  const auto k = static_cast<std::size_t>(s.integer(0, 7));
  const std::size_t other = k ^ (std::size_t{1} << s.integer(0, 2));
  return all[k] + s.unit() * (all[other] - all[k]);
}

// A needle past an edge of the box, by 1e-16 to 1.
TriangleAndBox needle(Sampler& s) {
  const Aabb box = any_box(s);
  const double beside = s.magnitude(-54, 0);
  const Vector3d edge_point = point_on_edge(s, box);
  const Vector3d target = edge_point + beside * s.point();
  const Vector3d axis = s.point();
  const Vector3d from = target - 3 * s.unit() * axis;
  const double width = s.magnitude(-50, -4);
  const Vector3d to = target + s.unit() * axis;
  const Vector3d apex = s.one_in(2) ? to : target;
  return {s.shuffled({from, to, apex + width * s.point()}), box};
}

// A cap with its apex within rounding of the long edge, at an edge of the box.
TriangleAndBox cap(Sampler& s) {
  const Aabb box = any_box(s);
  const Vector3d target = point_on_edge(s, box);
  const Vector3d axis = s.point();
  const Triangle t{target - axis, target + axis, target};
  return {s.shuffled(s.nudged(t, 1)), box};
}

// A box that is long and 1e-15 wide, through the triangle's border.
TriangleAndBox needle_box(Sampler& s) {
  const Triangle t = s.triangle();
  const double width = s.magnitude(-50, -4);
  const double beside = s.magnitude(-52, -4);
  const Vector3d target = point_at(t, s.unit(), 0);
  const Vector3d p = target + beside * s.point();
  const Vector3d size = width * s.point().cwiseAbs();
  const Vector3d length = s.one_in(2) ? Vector3d(0.5, 0, 0) : Vector3d(0.5, 0.5, 0);
  return {t, box_between(p, p + size + turned(s, length))};
}

}  // namespace

void add_thin_boxes(std::vector<BoxCategory>& categories) {
  categories.push_back({"needle_at_edge", needle});
  categories.push_back({"cap_at_edge", cap});
  categories.push_back({"needle_box", needle_box});
}

}  // namespace graze::oracle
