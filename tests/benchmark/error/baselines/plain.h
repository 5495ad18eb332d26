#pragma once

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/triangle.h>

#include <cmath>

// What the classic tests compute with: plain numbers of one precision, rounded as they come.

namespace graze::benchmark {

template <typename Real>
struct PlainTriangle {
  Real a[3];
  Real b[3];
  Real c[3];
};

/// Where three corners lie, three coordinates each.
template <typename Real>
struct Corners {
  const Real* p;
  const Real* q;
  const Real* r;
};

template <typename Real>
Corners<Real> corners_of(const PlainTriangle<Real>& t) {
  return {t.a, t.b, t.c};
}
inline Corners<double> corners_of(const Triangle& t) {
  return {t.a.data(), t.b.data(), t.c.data()};
}

template <typename Real>
struct PlainBox {
  Real min[3];
  Real max[3];
};

template <typename Real>
struct PlainVector {
  Real x, y, z;
};

template <typename Real>
PlainVector<Real> difference(const Real* a, const Real* b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <typename Real>
PlainVector<Real> cross(const PlainVector<Real>& a, const PlainVector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename Real>
Real dot(const PlainVector<Real>& a, const PlainVector<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Real>
PlainTriangle<Real> to_plain(const Triangle& t) {
  PlainTriangle<Real> result;
  for (int i = 0; i < 3; ++i) {
    result.a[i] = static_cast<Real>(t.a.data()[i]);
    result.b[i] = static_cast<Real>(t.b.data()[i]);
    result.c[i] = static_cast<Real>(t.c.data()[i]);
  }
  return result;
}

template <typename Real>
PlainBox<Real> to_plain(const Aabb& box) {
  PlainBox<Real> result;
  for (int i = 0; i < 3; ++i) {
    result.min[i] = static_cast<Real>(box.min.data()[i]);
    result.max[i] = static_cast<Real>(box.max.data()[i]);
  }
  return result;
}

/// Leaves every number as it is.
struct NoSnap {
  template <typename Real>
  Real operator()(Real value) const {
    return value;
  }
};

/// "Real-Time Rendering", 3rd ed., 16.11: what is below EPSILON is taken to be zero.
template <typename Number>
struct Snap {
  Number epsilon;
  Number operator()(Number value) const { return std::abs(value) < epsilon ? 0 : value; }
};

}  // namespace graze::benchmark
