#pragma once

// A vector is three doubles. Its functions are static so that each source compiles its own, with
// the flags of the floor: a copy that the linker shares with a user's could be one compiled with
// -ffast-math.

#include <cmath>

namespace graze::narrowphase {

struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;
};

static inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline Vec3 operator-(const Vec3& a) {
  return {-a.x, -a.y, -a.z};
}

static inline Vec3 operator*(const Vec3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}

static inline double dot(const Vec3& a, const Vec3& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

static inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

/// Returns the largest absolute coordinate.
static inline double largest(const Vec3& a) {
  const double x = std::abs(a.x);
  const double y = std::abs(a.y);
  const double z = std::abs(a.z);
  const double xy = x > y ? x : y;
  return xy > z ? xy : z;
}

/// Returns the vector of length 1 in the direction of `a`; `otherwise` if that is 0 or not finite.
/// It is scaled first, so that no square overflows or underflows.
static inline Vec3 unit_or(const Vec3& a, const Vec3& otherwise) {
  const double size = largest(a);
  if (!(size > 0) || !std::isfinite(size)) return otherwise;
  const Vec3 scaled{a.x / size, a.y / size, a.z / size};
  return scaled * (1 / length(scaled));
}

/// Returns some unit vector at right angles to the unit vector `n`.
static inline Vec3 any_normal_to(const Vec3& n) {
  const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return unit_or(cross(n, axis), axis);
}

}  // namespace graze::narrowphase
