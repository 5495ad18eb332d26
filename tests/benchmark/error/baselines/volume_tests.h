#pragma once

#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>

#include <algorithm>
#include <initializer_list>

#include "tests/benchmark/error/baselines/plain.h"

// Oriented boxes and k-DOPs, rounded, as their users have them.

namespace graze::benchmark {

template <typename Real>
struct PlainObb {
  Real axis[3][3];  ///< axis[i] is the direction of edge i
  Real centre[3];
  Real half[3];
};

template <typename Real>
PlainObb<Real> to_plain(const Obb& box) {
  PlainObb<Real> result;
  const double* m = box.pose.data();  // column-major 4x4
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      result.axis[i][k] = static_cast<Real>(m[4 * i + k]);
    result.centre[i] = static_cast<Real>(m[12 + i]);
    result.half[i] = static_cast<Real>(box.half_extents.data()[i]);
  }
  return result;
}

/// Gottschalk's fifteen axes in the frame of A; `epsilon` is added to each absolute value of the
/// rotation. Gottschalk, Lin, Manocha, "OBBTree", 1996; Ericson, "Real-Time Collision Detection",
/// 2005, 4.4.
template <typename Real>
bool fifteen_axes(const PlainObb<Real>& a, const PlainObb<Real>& b, Real epsilon) {
  const auto along = [](const Real* p, const Real* q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  Real r[3][3], size[3][3], t[3];
  const Real between[3] = {b.centre[0] - a.centre[0], b.centre[1] - a.centre[1],
                           b.centre[2] - a.centre[2]};
  for (int i = 0; i < 3; ++i) {
    t[i] = along(a.axis[i], between);
    for (int j = 0; j < 3; ++j) {
      r[i][j] = along(a.axis[i], b.axis[j]);
      size[i][j] = std::abs(r[i][j]) + epsilon;
    }
  }
  for (int i = 0; i < 3; ++i) {
    if (std::abs(t[i]) > a.half[i] + along(b.half, size[i])) return false;
  }
  for (int j = 0; j < 3; ++j) {
    const Real distance = t[0] * r[0][j] + t[1] * r[1][j] + t[2] * r[2][j];
    const Real reach = a.half[0] * size[0][j] + a.half[1] * size[1][j] + a.half[2] * size[2][j];
    if (std::abs(distance) > reach + b.half[j]) return false;
  }
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const Real distance = t[i2] * r[i1][j] - t[i1] * r[i2][j];
      const Real reach_a = a.half[i1] * size[i2][j] + a.half[i2] * size[i1][j];
      const Real reach_b = b.half[j1] * size[i][j2] + b.half[j2] * size[i][j1];
      if (std::abs(distance) > reach_a + reach_b) return false;
    }
  }
  return true;
}

template <typename Real>
struct PlainKDop {
  Real min[9];
  Real max[9];
};

/// Around the corners, each sum rounded to the nearest.
template <typename Real>
PlainKDop<Real> plain_kdop(const Triangle& t) {
  PlainKDop<Real> result;
  const PlainTriangle<Real> plain = to_plain<Real>(t);
  for (int k = 0; k < 9; ++k) {
    const auto& d = kKDopDirections<18>[static_cast<std::size_t>(k)];
    const auto value = [&](const Real* p) {
      return static_cast<Real>(d[0]) * p[0] + static_cast<Real>(d[1]) * p[1] +
             static_cast<Real>(d[2]) * p[2];
    };
    const Real a = value(plain.a), b = value(plain.b), c = value(plain.c);
    result.min[k] = std::min({a, b, c});
    result.max[k] = std::max({a, b, c});
  }
  return result;
}

template <typename Real>
bool plain_kdops(const PlainKDop<Real>& a, const PlainKDop<Real>& b) {
  for (int k = 0; k < 9; ++k) {
    if (a.min[k] > b.max[k] || b.min[k] > a.max[k]) return false;
  }
  return true;
}

}  // namespace graze::benchmark
