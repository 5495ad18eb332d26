#include "tests/benchmark/error/baselines/guigue_devillers.h"

#include <utility>

namespace graze::benchmark {
namespace {

/// ((b - a) x (c - a)) . (d - a)
template <typename Real>
Real volume(const Real* a, const Real* b, const Real* c, const Real* d) {
  return dot(cross(difference(b, a), difference(c, a)), difference(d, a));
}

template <typename Real>
Real area(const Real* a, const Real* b, const Real* c, int x, int y) {
  return (b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]);
}

/// Some edge of `s`, which turns counter-clockwise, has all of `t` beyond it.
template <typename Real>
bool has_separating_edge(const Corners<Real>& s, const Corners<Real>& t, int x, int y) {
  const Real* corner[3] = {s.p, s.q, s.r};
  for (int i = 0; i < 3; ++i) {
    const Real* from = corner[i];
    const Real* to = corner[(i + 1) % 3];
    if (area(from, to, t.p, x, y) < 0 && area(from, to, t.q, x, y) < 0 &&
        area(from, to, t.r, x, y) < 0) {
      return true;
    }
  }
  return false;
}

template <typename Real>
bool meet_in_plane(Corners<Real> a, Corners<Real> b, const PlainVector<Real>& normal) {
  const Real size_x = std::abs(normal.x);
  const Real size_y = std::abs(normal.y);
  const Real size_z = std::abs(normal.z);
  const int axis = size_x > size_y ? (size_x > size_z ? 0 : 2) : (size_y > size_z ? 1 : 2);
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  if (area(a.p, a.q, a.r, x, y) < 0) std::swap(a.q, a.r);
  if (area(b.p, b.q, b.r, x, y) < 0) std::swap(b.q, b.r);
  return !has_separating_edge(a, b, x, y) && !has_separating_edge(b, a, x, y);
}

/// Turns the triangle, keeping its orientation, until the vertex that is alone on its side of the
/// other's plane comes first. True if that vertex is on the negative side. (0, 0, 0) must not be.
template <typename Real>
bool put_lone_vertex_first(Corners<Real>& t, Real p, Real q, Real r) {
  const auto turned_once = [&] { t = {t.q, t.r, t.p}; };
  const auto turned_twice = [&] { t = {t.r, t.p, t.q}; };
  if (p > 0) {
    if (q > 0) return turned_twice(), true;  // r alone, below or in the plane
    if (r > 0) return turned_once(), true;   // q alone
    return false;                            // p alone, above
  }
  if (p < 0) {
    if (q < 0) return turned_twice(), false;
    if (r < 0) return turned_once(), false;
    return true;
  }
  if (q > 0) {
    if (r > 0) return true;
    return turned_once(), false;
  }
  if (q < 0) {
    if (r < 0) return false;
    return turned_once(), true;
  }
  return turned_twice(), r < 0;
}

}  // namespace

template <typename Real, typename Snapping>
bool guigue_devillers(const Corners<Real>& triangle_a, const Corners<Real>& triangle_b,
                      Snapping snap) {
  Corners<Real> a = triangle_a;
  Corners<Real> b = triangle_b;
  const PlainVector<Real> normal_b = cross(difference(b.p, b.r), difference(b.q, b.r));
  const Real a_p = snap(dot(normal_b, difference(a.p, b.r)));
  const Real a_q = snap(dot(normal_b, difference(a.q, b.r)));
  const Real a_r = snap(dot(normal_b, difference(a.r, b.r)));
  if (a_p * a_q > 0 && a_p * a_r > 0) return false;
  const PlainVector<Real> normal_a = cross(difference(a.q, a.p), difference(a.r, a.p));
  const Real b_p = snap(dot(normal_a, difference(b.p, a.r)));
  const Real b_q = snap(dot(normal_a, difference(b.q, a.r)));
  const Real b_r = snap(dot(normal_a, difference(b.r, a.r)));
  if (b_p * b_q > 0 && b_p * b_r > 0) return false;
  if ((a_p == 0 && a_q == 0 && a_r == 0) || (b_p == 0 && b_q == 0 && b_r == 0)) {
    return meet_in_plane(a, b, normal_a);
  }
  const bool is_a_below = put_lone_vertex_first(a, a_p, a_q, a_r);
  const bool is_b_below = put_lone_vertex_first(b, b_p, b_q, b_r);
  if (is_a_below) std::swap(b.q, b.r);
  if (is_b_below) std::swap(a.q, a.r);
  // The paper's interval test, figure 5.
  return snap(volume(a.p, a.q, b.p, b.q)) <= 0 && snap(volume(a.p, a.r, b.r, b.p)) <= 0;
}

using FloatCorners = Corners<float>;
using DoubleCorners = Corners<double>;
template bool guigue_devillers(const FloatCorners&, const FloatCorners&, NoSnap);
template bool guigue_devillers(const FloatCorners&, const FloatCorners&, Snap<float>);
template bool guigue_devillers(const DoubleCorners&, const DoubleCorners&, NoSnap);
template bool guigue_devillers(const DoubleCorners&, const DoubleCorners&, Snap<double>);

}  // namespace graze::benchmark
