#include <tests/oracle/category.h>

// Triangles and boxes in general position.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

TriangleAndBox anywhere(Sampler& s) {
  const Vector3d p = s.point();
  const Vector3d size = 0.7 * s.point();
  return {s.triangle(), box_between(p, p + size)};
}

TriangleAndBox small_triangle(Sampler& s) {
  const Vector3d p = s.point();
  const Aabb box = box_between(p, s.point());
  const Vector3d near = corners(box)[static_cast<std::size_t>(s.integer(0, 7))];
  const Triangle shape = scaled(s.triangle(), 0.3);
  return {moved(shape, near + 0.3 * s.point()), box};
}

TriangleAndBox small_box(Sampler& s) {
  const Triangle t = s.triangle();
  const double size = s.magnitude(-8, -2);
  const Vector3d near = s.point_in(t);
  const Vector3d p = near + size * s.point();
  return {t, box_between(p, p + size * s.point())};
}

}  // namespace

void add_random_boxes(std::vector<BoxCategory>& categories) {
  categories.push_back({"random", anywhere});
  categories.push_back({"random_small_triangle", small_triangle});
  categories.push_back({"random_small_box", small_box});
}

}  // namespace graze::oracle
