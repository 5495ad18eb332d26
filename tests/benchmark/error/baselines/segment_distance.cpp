#include "tests/benchmark/error/baselines/segment_distance.h"

#include <algorithm>

namespace graze::benchmark {
namespace {

template <typename Real>
PlainVector<Real> minus(const PlainVector<Real>& a, const PlainVector<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <typename Real>
PlainVector<Real> times(const PlainVector<Real>& a, Real factor) {
  return {a.x * factor, a.y * factor, a.z * factor};
}

template <typename Real>
Real clamped(Real s) {
  return std::min(std::max(s, Real(0)), Real(1));
}

/// Squared, between the segments pq and rs.
template <typename Real>
Real between_segments(const Real* p, const Real* q, const Real* r, const Real* s) {
  const auto d = difference(q, p), e = difference(s, r), w = difference(p, r);
  const Real a = dot(d, d), g = dot(e, e), f = dot(e, w);
  Real along_d = 0, along_e = 0;
  if (a == 0) {
    along_e = g == 0 ? 0 : clamped(f / g);
  } else {
    const Real c = dot(d, w);
    if (g == 0) {
      along_d = clamped(-c / a);
    } else {
      const Real b = dot(d, e);
      const Real denominator = a * g - b * b;
      if (denominator != 0) along_d = clamped((b * f - c * g) / denominator);
      along_e = (b * along_d + f) / g;
      if (along_e < 0) {
        along_e = 0;
        along_d = clamped(-c / a);
      } else if (along_e > 1) {
        along_e = 1;
        along_d = clamped((b - c) / a);
      }
    }
  }
  const auto way = minus(minus(w, times(e, along_e)), times(d, -along_d));
  return dot(way, way);
}

/// Whether the foot of p lies in the triangle, seen along its normal.
template <typename Real>
bool is_over(const Real* p, const Corners<Real>& t, const PlainVector<Real>& normal) {
  return dot(cross(difference(t.q, t.p), difference(p, t.p)), normal) >= 0 &&
         dot(cross(difference(t.r, t.q), difference(p, t.q)), normal) >= 0 &&
         dot(cross(difference(t.p, t.r), difference(p, t.r)), normal) >= 0;
}

/// The least of `best` and the squared heights of the corners of s that are over t; 0 if an edge of
/// s crosses t.
template <typename Real>
Real with_face(const Corners<Real>& s, const Corners<Real>& t, Real best) {
  const auto normal = cross(difference(t.q, t.p), difference(t.r, t.p));
  const Real square = dot(normal, normal);
  if (square == 0) return best;
  const Real* corner[3] = {s.p, s.q, s.r};
  Real height[3];
  for (int i = 0; i < 3; ++i) {
    height[i] = dot(difference(corner[i], t.p), normal);
    if (is_over(corner[i], t, normal)) best = std::min(best, height[i] * height[i] / square);
  }
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3;
    if (!((height[i] < 0) != (height[k] < 0))) continue;
    const Real along = height[i] / (height[i] - height[k]);
    Real crossing[3];
    for (int axis = 0; axis < 3; ++axis)
      crossing[axis] = corner[i][axis] + along * (corner[k][axis] - corner[i][axis]);
    if (is_over(crossing, t, normal)) return 0;
  }
  return best;
}

}  // namespace

template <typename Real>
Real segment_distance(const Corners<Real>& triangle_a, const Corners<Real>& triangle_b) {
  const Real* a[3] = {triangle_a.p, triangle_a.q, triangle_a.r};
  const Real* b[3] = {triangle_b.p, triangle_b.q, triangle_b.r};
  Real best = between_segments(a[0], a[1], b[0], b[1]);
  for (int i = 0; i < 9; ++i) {
    best = std::min(best,
                    between_segments(a[i / 3], a[(i / 3 + 1) % 3], b[i % 3], b[(i % 3 + 1) % 3]));
  }
  best = with_face(triangle_a, triangle_b, best);
  best = with_face(triangle_b, triangle_a, best);
  return std::sqrt(best);
}

template double segment_distance(const Corners<double>&, const Corners<double>&);
template float segment_distance(const Corners<float>&, const Corners<float>&);

}  // namespace graze::benchmark
