#include <tests/oracle/base_elements.h>
#include <tests/oracle/category.h>
#include <cmath>
#include <limits>

// The ends of the range of double, for triangles and boxes.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

TriangleAndBox scaled_by(Sampler& s, int low, int high) {
  const TriangleAndBox pair = base_box(s);
  return scaled(pair, std::ldexp(1.0, s.integer(low, high)));
}

TriangleAndBox large(Sampler& s) {
  return scaled_by(s, 200, 500);
}
TriangleAndBox small(Sampler& s) {
  return scaled_by(s, -530, -200);
}
TriangleAndBox tiny(Sampler& s) {
  return scaled_by(s, -1060, -900);
}
TriangleAndBox denormal(Sampler& s) {
  return scaled_by(s, -1040, -1023);
}

// Coordinates up to the largest double, and differences and sums beyond it.
TriangleAndBox nearly_infinite(Sampler& s) {
  const double largest = std::numeric_limits<double>::max();
  const bool is_lattice = s.one_in(2);
  const auto point = [&] {
    return Vector3d((is_lattice ? s.whole_point(1) : s.point()) * largest);
  };
  const Triangle t{point(), point(), point()};
  const Vector3d p = point();
  return {t, box_between(p, 0.5 * point())};
}

Vector3d extreme_point(Sampler& s) {
  const auto coordinate = [&] {
    const double sign = s.sign();
    return s.one_in(8) ? 0 : sign * s.magnitude(-530, 500);
  };
  return {coordinate(), coordinate(), coordinate()};
}

TriangleAndBox mixed(Sampler& s) {
  const Triangle t{extreme_point(s), extreme_point(s), extreme_point(s)};
  const Vector3d p = extreme_point(s);
  return {t, box_between(p, extreme_point(s))};
}

TriangleAndBox stretched(Sampler& s) {
  const TriangleAndBox pair = base_box(s);
  const auto factor = [&] { return std::ldexp(1.0, s.integer(-530, 490)); };
  const Vector3d factors{factor(), factor(), factor()};
  const auto stretch = [&](const Vector3d& p) { return Vector3d(p.cwiseProduct(factors)); };
  return {for_each_vertex(pair.triangle, stretch), {stretch(pair.box.min), stretch(pair.box.max)}};
}

TriangleAndBox denormal_lattice(Sampler& s) {
  const int reach = s.one_in(2) ? 3 : 1000;
  const Triangle t = s.whole_triangle(2 * reach);
  const Vector3d p = s.whole_point(reach);
  return scaled(TriangleAndBox{t, box_between(p, s.whole_point(reach))}, kDenormal);
}

// An ordinary lattice with some coordinates moved off by the smallest step that they have.
TriangleAndBox denormal_beside_normal(Sampler& s) {
  const auto point = [&](int reach) {
    Vector3d p = s.whole_point(reach);
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] == 0 && s.one_in(2)) p[axis] = s.integer(-2, 2) * kDenormal;
    }
    return p;
  };
  const Triangle t{point(2), point(2), point(2)};
  const Vector3d p = point(1);
  return {t, box_between(p, point(1))};
}

// The two zeros are one number, for vertices and for the sides of boxes.
TriangleAndBox signed_zeros(Sampler& s) {
  const auto point = [&] {
    Vector3d p = s.whole_point(1);
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] == 0 && s.one_in(2)) p[axis] = -0.0;
    }
    return p;
  };
  const Triangle t{point(), point(), point()};
  const Vector3d corner = t.a + point();
  Aabb box = box_between(corner, t.b + point());
  if (s.one_in(2)) {
    const Vector3d p = point();
    box = box_between(p, point());
  }
  return {s.shuffled(t), box};
}

}  // namespace

void add_extreme_boxes(std::vector<BoxCategory>& categories) {
  categories.push_back({"extreme_large", large, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_small", small, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_tiny", tiny, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_nearly_infinite", nearly_infinite, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_mixed", mixed, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_stretched", stretched, Answers::Mixed, Range::Double});
  categories.push_back({"denormal", denormal, Answers::Mixed, Range::Double});
  categories.push_back({"denormal_lattice", denormal_lattice, Answers::Mixed, Range::Double});
  categories.push_back(
      {"denormal_beside_normal", denormal_beside_normal, Answers::Mixed, Range::Double});
  categories.push_back({"signed_zeros", signed_zeros});
}

}  // namespace graze::oracle
