#include "tests/benchmark/error/baselines/moeller.h"

#include <algorithm>

namespace graze::benchmark {
namespace {

template <typename Real>
struct Interval {
  Real low, high;
};

/// Where the edges that cross the plane cross it, along the line of the two planes: `at` are the
/// positions of the vertices along that line, `d` their distances from the plane, not all zero.
/// The vertex alone on its side is the one that both crossing edges share.
template <typename Real>
Interval<Real> crossing(const Real (&at)[3], const Real (&d)[3]) {
  int apex = 0;
  if (d[0] * d[1] > 0) {
    apex = 2;
  } else if (d[0] * d[2] > 0) {
    apex = 1;
  } else if (d[1] * d[2] > 0 || d[0] != 0) {
    apex = 0;
  } else {
    apex = d[1] != 0 ? 1 : 2;
  }
  const int one = (apex + 1) % 3;
  const int two = (apex + 2) % 3;
  const Real s = at[apex] + (at[one] - at[apex]) * d[apex] / (d[apex] - d[one]);
  const Real t = at[apex] + (at[two] - at[apex]) * d[apex] / (d[apex] - d[two]);
  return {std::min(s, t), std::max(s, t)};
}

template <typename Real>
Real area(const Real* a, const Real* b, const Real* c, int x, int y) {
  return (b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]);
}

/// Franklin Antonio, "Faster line segment intersection", Graphics Gems III, 1992.
template <typename Real>
bool do_edges_meet(const Real* p, const Real* q, const Real* u, const Real* v, int x, int y) {
  const Real ax = q[x] - p[x], ay = q[y] - p[y];
  const Real bx = u[x] - v[x], by = u[y] - v[y];
  const Real cx = p[x] - u[x], cy = p[y] - u[y];
  const Real f = ay * bx - ax * by;
  const Real d = by * cx - bx * cy;
  if (!((f > 0 && d >= 0 && d <= f) || (f < 0 && d <= 0 && d >= f))) return false;
  const Real e = ax * cy - ay * cx;
  return f > 0 ? e >= 0 && e <= f : e <= 0 && e >= f;
}

template <typename Real>
bool is_inside(const Real* p, const Real* const (&t)[3], int x, int y) {
  const Real first = area(t[0], t[1], p, x, y);
  const Real second = area(t[1], t[2], p, x, y);
  const Real third = area(t[2], t[0], p, x, y);
  return first * second > 0 && first * third > 0;
}

/// Edges against edges, then a vertex of each in the other.
template <typename Real>
bool meet_in_plane(const PlainVector<Real>& normal, const Real* const (&a)[3],
                   const Real* const (&b)[3]) {
  const Real size_x = std::abs(normal.x);
  const Real size_y = std::abs(normal.y);
  const Real size_z = std::abs(normal.z);
  const int axis = size_x > size_y ? (size_x > size_z ? 0 : 2) : (size_z > size_y ? 2 : 1);
  const int x = axis == 0 ? 1 : 0;
  const int y = axis == 2 ? 1 : 2;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (do_edges_meet(a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3], x, y)) return true;
    }
  }
  return is_inside(a[0], b, x, y) || is_inside(b[0], a, x, y);
}

}  // namespace

template <typename Real, typename Snapping>
bool moeller(const Corners<Real>& triangle_a, const Corners<Real>& triangle_b, Snapping snap) {
  const Real* const a[3] = {triangle_a.p, triangle_a.q, triangle_a.r};
  const Real* const b[3] = {triangle_b.p, triangle_b.q, triangle_b.r};
  const PlainVector<Real> normal_a = cross(difference(a[1], a[0]), difference(a[2], a[0]));
  const PlainVector<Real> origin_a{a[0][0], a[0][1], a[0][2]};
  const Real offset_a = -dot(normal_a, origin_a);
  const auto from_a = [&](const Real* p) {
    return snap(dot(normal_a, PlainVector<Real>{p[0], p[1], p[2]}) + offset_a);
  };
  const Real distances_b[3] = {from_a(b[0]), from_a(b[1]), from_a(b[2])};
  if (distances_b[0] * distances_b[1] > 0 && distances_b[0] * distances_b[2] > 0) return false;
  const PlainVector<Real> normal_b = cross(difference(b[1], b[0]), difference(b[2], b[0]));
  const PlainVector<Real> origin_b{b[0][0], b[0][1], b[0][2]};
  const Real offset_b = -dot(normal_b, origin_b);
  const auto from_b = [&](const Real* p) {
    return snap(dot(normal_b, PlainVector<Real>{p[0], p[1], p[2]}) + offset_b);
  };
  const Real distances_a[3] = {from_b(a[0]), from_b(a[1]), from_b(a[2])};
  if (distances_a[0] * distances_a[1] > 0 && distances_a[0] * distances_a[2] > 0) return false;
  const auto all_zero = [](const Real(&d)[3]) { return d[0] == 0 && d[1] == 0 && d[2] == 0; };
  if (all_zero(distances_a) || all_zero(distances_b)) return meet_in_plane(normal_a, a, b);
  const PlainVector<Real> line = cross(normal_a, normal_b);
  int along = 0;
  Real largest = std::abs(line.x);
  if (std::abs(line.y) > largest) along = 1, largest = std::abs(line.y);
  if (std::abs(line.z) > largest) along = 2;
  const Real at_a[3] = {a[0][along], a[1][along], a[2][along]};
  const Real at_b[3] = {b[0][along], b[1][along], b[2][along]};
  const Interval<Real> interval_a = crossing(at_a, distances_a);
  const Interval<Real> interval_b = crossing(at_b, distances_b);
  return !(interval_a.high < interval_b.low || interval_b.high < interval_a.low);
}

using FloatCorners = Corners<float>;
using DoubleCorners = Corners<double>;
template bool moeller(const FloatCorners&, const FloatCorners&, NoSnap);
template bool moeller(const FloatCorners&, const FloatCorners&, Snap<float>);
template bool moeller(const DoubleCorners&, const DoubleCorners&, NoSnap);
template bool moeller(const DoubleCorners&, const DoubleCorners&, Snap<double>);

}  // namespace graze::benchmark
