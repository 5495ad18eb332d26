#include "tests/narrowphase/volumes/rational_spheres.h"

#include <gmpxx.h>
#include <algorithm>
#include <array>
#include <optional>

namespace graze::oracle {
namespace {

using Vector = std::array<mpq_class, 3>;

Vector rational(const Eigen::Vector3d& v) {
  return {mpq_class(v[0]), mpq_class(v[1]), mpq_class(v[2])};
}

Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

mpq_class dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

mpq_class squared(const mpq_class& a) {
  return a * a;
}

/// From the centre to the nearest point of the box along one axis, not negative.
mpq_class way_to_box(const mpq_class& centre, const mpq_class& low, const mpq_class& high) {
  if (centre < low) return low - centre;
  if (centre > high) return centre - high;
  return 0;
}

/// Of all points of the box.
mpq_class least_distance2(const Sphere& sphere, const Aabb& box) {
  const Vector c = rational(sphere.centre), low = rational(box.min), high = rational(box.max);
  mpq_class sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += squared(way_to_box(c[i], low[i], high[i]));
  return sum;
}

/// Of all points of the six faces, each of which is a flat box.
mpq_class least_distance2(const Sphere& sphere, const HollowAabb& hollow) {
  std::optional<mpq_class> least;
  for (int face = 0; face < 6; ++face) {
    Aabb flat = hollow.box;
    const int axis = face / 2;
    (face % 2 == 0 ? flat.max[axis] : flat.min[axis]) =
        face % 2 == 0 ? hollow.box.min[axis] : hollow.box.max[axis];
    const mpq_class distance2 = least_distance2(sphere, flat);
    if (!least || distance2 < *least) least = distance2;
  }
  return *least;
}

/// Of the eight corners.
mpq_class largest_distance2(const Sphere& sphere, const Aabb& box) {
  const Vector c = rational(sphere.centre), low = rational(box.min), high = rational(box.max);
  mpq_class largest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vector p;
    for (int i = 0; i < 3; ++i)
      p[i] = (corner >> i & 1) != 0 ? high[i] : low[i];
    const Vector way = minus(p, c);
    const mpq_class distance2 = dot(way, way);
    if (distance2 > largest) largest = distance2;
  }
  return largest;
}

mpq_class distance2_to_segment(const Vector& p, const Vector& a, const Vector& b) {
  const Vector f = minus(b, a);
  const mpq_class length2 = dot(f, f);
  mpq_class t = 0;
  if (length2 != 0) t = dot(minus(p, a), f) / length2;
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const Vector foot = {a[0] + t * f[0], a[1] + t * f[1], a[2] + t * f[2]};
  const Vector way = minus(p, foot);
  return dot(way, way);
}

/// To the foot on the plane, from the normal equations, if it exists and lies in the triangle.
std::optional<mpq_class> distance2_to_face(const Vector& p, const Vector& a, const Vector& b,
                                           const Vector& c) {
  const Vector s = minus(b, a), t = minus(c, a), w = minus(p, a);
  const mpq_class ss = dot(s, s), st = dot(s, t), tt = dot(t, t);
  const mpq_class determinant = ss * tt - st * st;
  if (determinant == 0) return std::nullopt;
  const mpq_class ws = dot(w, s), wt = dot(w, t);
  const mpq_class v = (tt * ws - st * wt) / determinant;
  const mpq_class u = (ss * wt - st * ws) / determinant;
  if (v < 0 || u < 0 || v + u > 1) return std::nullopt;
  Vector way;
  for (int i = 0; i < 3; ++i)
    way[i] = w[i] - v * s[i] - u * t[i];
  return dot(way, way);
}

}  // namespace

bool overlap(const Sphere& a, const Sphere& b) {
  const Vector way = minus(rational(a.centre), rational(b.centre));
  return dot(way, way) <= squared(mpq_class(a.radius) + mpq_class(b.radius));
}

bool overlap(const Sphere& sphere, const Aabb& box) {
  return least_distance2(sphere, box) <= squared(sphere.radius);
}

bool overlap(const Sphere& sphere, const HollowAabb& box) {
  return least_distance2(sphere, box) <= squared(sphere.radius);
}

bool overlap(const HollowSphere& hollow, const Aabb& box) {
  const mpq_class radius2 = squared(hollow.sphere.radius);
  return least_distance2(hollow.sphere, box) <= radius2 &&
         radius2 <= largest_distance2(hollow.sphere, box);
}

bool overlap(const HollowSphere& hollow, const HollowAabb& box) {
  const mpq_class radius2 = squared(hollow.sphere.radius);
  return least_distance2(hollow.sphere, box) <= radius2 &&
         radius2 <= largest_distance2(hollow.sphere, box.box);
}

bool overlap(const Ellipsoid& ellipsoid, const Aabb& box) {
  const Vector c = rational(ellipsoid.centre), axes = rational(ellipsoid.semi_axes);
  const Vector low = rational(box.min), high = rational(box.max);
  mpq_class sum = 0;
  for (int i = 0; i < 3; ++i) {
    const mpq_class way = way_to_box(c[i], low[i], high[i]);
    if (way == 0) continue;
    if (axes[i] == 0) return false;
    sum += squared(way / axes[i]);
  }
  return sum <= 1;
}

bool overlap(const Triangle& triangle, const Sphere& sphere) {
  const Vector p = rational(sphere.centre);
  const Vector a = rational(triangle.a), b = rational(triangle.b), c = rational(triangle.c);
  mpq_class least = distance2_to_segment(p, a, b);
  for (const mpq_class& other : {distance2_to_segment(p, b, c), distance2_to_segment(p, c, a)}) {
    if (other < least) least = other;
  }
  if (const auto face = distance2_to_face(p, a, b, c); face && *face < least) least = *face;
  return least <= squared(mpq_class(sphere.radius));
}

}  // namespace graze::oracle
