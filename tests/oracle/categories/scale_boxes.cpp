#include <tests/oracle/base_elements.h>
#include <tests/oracle/category.h>
#include <cmath>

// Far from the origin, and of very different sizes.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

TriangleAndBox far_away(Sampler& s) {
  const double distance = s.magnitude(20, 49);
  const Vector3d offset = distance * s.point();
  return moved(base_box(s), offset);
}

TriangleAndBox far_along_axis(Sampler& s) {
  const double distance = s.magnitude(20, 49);
  const Vector3d offset = turned(s, Vector3d(distance, 0, 0));
  return moved(base_box(s), offset);
}

Vector3d mixed_point(Sampler& s) {
  const auto coordinate = [&] {
    const double sign = s.sign();
    return sign * s.magnitude(-20, 20);
  };
  return {coordinate(), coordinate(), coordinate()};
}

TriangleAndBox mixed_coordinates(Sampler& s) {
  const Triangle t{mixed_point(s), mixed_point(s), mixed_point(s)};
  const Vector3d p = mixed_point(s);
  return {t, box_between(p, mixed_point(s))};
}

// A large triangle cuts near a corner of a small box.
TriangleAndBox mixed_between(Sampler& s) {
  const double size_t = s.magnitude(-3, 3);
  const Triangle t = scaled(s.triangle(), size_t);
  const double size = s.magnitude(-20, -4);
  const Vector3d near = s.point_in(t);
  const Vector3d p = near + size * s.point();
  return {t, box_between(p, p + size * s.point())};
}

TriangleAndBox stretched(Sampler& s) {
  const TriangleAndBox pair = base_box(s);
  const auto factor = [&] { return std::ldexp(1.0, s.integer(-20, 20)); };
  const Vector3d factors{factor(), factor(), factor()};
  const auto stretch = [&](const Vector3d& p) { return Vector3d(p.cwiseProduct(factors)); };
  return {for_each_vertex(pair.triangle, stretch), {stretch(pair.box.min), stretch(pair.box.max)}};
}

}  // namespace

void add_scale_boxes(std::vector<BoxCategory>& categories) {
  categories.push_back({"far_away", far_away});
  categories.push_back({"far_along_axis", far_along_axis});
  categories.push_back({"scales_mixed_coordinates", mixed_coordinates});
  categories.push_back({"scales_mixed_between", mixed_between});
  categories.push_back({"scales_stretched", stretched});
}

}  // namespace graze::oracle
