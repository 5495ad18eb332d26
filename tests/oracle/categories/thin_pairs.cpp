#include <tests/oracle/category.h>

// Needles and caps: triangles whose width is down to 1e-15 of their length.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

// From `from` along `axis`; the third vertex off the long edge by a tiny part of its length, near
// an end (a needle) or anywhere along it (a cap).
Triangle thin(Sampler& s, const Vector3d& from, const Vector3d& axis) {
  const double width = s.magnitude(-50, -4);
  const double along = s.one_in(2) ? 1 : s.unit();
  const Vector3d apex = from + along * axis + width * s.point();
  return s.shuffled({from, from + axis, apex});
}

// A needle whose line passes through the point.
Triangle thin_through(Sampler& s, const Vector3d& p) {
  const Vector3d axis = 2 * s.point();
  return thin(s, p - s.unit() * axis, axis);
}

TrianglePair needle_through_triangle(Sampler& s) {
  const Triangle a = s.triangle();
  const double beside = s.one_in(2) ? 0 : s.magnitude(-50, 0);
  const Vector3d on_edge = point_at(a, s.unit(), 0);
  return {a, thin_through(s, on_edge + beside * s.point())};
}

TrianglePair crossing_needles(Sampler& s) {
  const Vector3d axis = 2 * s.point();
  const Vector3d p = s.point();
  const Triangle a = thin(s, p, axis);
  const double along = s.unit();
  const double beside = s.magnitude(-54, -4);
  return {a, thin_through(s, p + along * axis + beside * s.point())};
}

// Nearly parallel, side by side.
TrianglePair bundled_needles(Sampler& s) {
  const Vector3d axis = 2 * s.point();
  const Vector3d p = s.point();
  const Triangle a = thin(s, p, axis);
  const double gap = s.magnitude(-54, -10);
  const Vector3d q = p + s.symmetric() / 2 * axis;
  const Vector3d beside = gap * s.point();
  const Vector3d tilt = gap * s.point();
  return {a, thin(s, q + beside, axis + tilt)};
}

// The second begins at the first, or a hair beside it.
TrianglePair needles_in_axis_plane(Sampler& s) {
  const double height = s.symmetric();
  const auto flat = [&](const Vector3d& p) { return Vector3d(p.x(), p.y(), height); };
  const Vector3d axis = 2 * s.point();
  const Vector3d p = s.point();
  const Triangle a = thin(s, p, axis);
  const Vector3d start = p + s.unit() * axis;
  const double beside = s.magnitude(-54, -4);
  const Vector3d from = start + beside * s.point();
  const TrianglePair pair{a, thin(s, from, s.point())};
  return turned(s, TrianglePair{for_each_vertex(pair.a, flat), for_each_vertex(pair.b, flat)});
}

// A cap with its apex on the long edge, but for rounding, against an edge that crosses there.
TrianglePair flattest_caps(Sampler& s) {
  const Triangle t = s.triangle();
  const Triangle a{t.a, t.b, s.nudged(point_at(t, s.unit(), 0), 1)};
  const Vector3d crossing = s.nudged(point_at(t, s.unit(), 0), 1);
  const Vector3d axis = s.point();
  const Vector3d third = crossing + s.point();
  return {s.shuffled(a),
          s.shuffled({s.one_in(2) ? crossing : crossing - axis, crossing + axis, third})};
}

}  // namespace

void add_thin_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"needle_through_triangle", needle_through_triangle});
  categories.push_back({"needles_crossing", crossing_needles});
  categories.push_back({"needles_bundled", bundled_needles});
  categories.push_back({"needles_in_axis_plane", needles_in_axis_plane});
  categories.push_back({"caps_flattest", flattest_caps});
}

}  // namespace graze::oracle
