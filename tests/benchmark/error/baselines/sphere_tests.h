#pragma once

#include <graze/bvh/sphere.h>

#include "tests/benchmark/error/baselines/plain.h"

// Balls against boxes and balls, rounded; closed, as the library is. "Real-Time Rendering", 3rd
// ed., 16.13.

namespace graze::benchmark {

template <typename Real>
struct PlainSphere {
  Real centre[3];
  Real radius;
};

/// Arvo, "A simple method for box-sphere intersection testing", Graphics Gems, 1990.
template <typename Real>
bool arvo(const PlainSphere<Real>& sphere, const PlainBox<Real>& box) {
  Real d = 0;
  for (int i = 0; i < 3; ++i) {
    if (sphere.centre[i] < box.min[i]) {
      const Real e = sphere.centre[i] - box.min[i];
      d += e * e;
    } else if (sphere.centre[i] > box.max[i]) {
      const Real e = sphere.centre[i] - box.max[i];
      d += e * e;
    }
  }
  return d <= sphere.radius * sphere.radius;
}

/// Larsson, Akenine-Möller, Lengyel, "On faster sphere-box overlap testing", 2007: quick rejections
/// intertwined.
template <typename Real>
bool quick_rejections(const PlainSphere<Real>& sphere, const PlainBox<Real>& box) {
  Real d = 0;
  for (int i = 0; i < 3; ++i) {
    Real e = sphere.centre[i] - box.min[i];
    if (e < 0) {
      if (e < -sphere.radius) return false;
      d += e * e;
    } else {
      e = sphere.centre[i] - box.max[i];
      if (e > 0) {
        if (e > sphere.radius) return false;
        d += e * e;
      }
    }
  }
  return d <= sphere.radius * sphere.radius;
}

/// The same authors: without branches.
template <typename Real>
bool branch_free(const PlainSphere<Real>& sphere, const PlainBox<Real>& box) {
  const auto positive = [](Real x) { return (x + std::abs(x)) / 2; };
  Real d = 0;
  for (int i = 0; i < 3; ++i) {
    const Real e =
        positive(box.min[i] - sphere.centre[i]) + positive(sphere.centre[i] - box.max[i]);
    d += e * e;
  }
  return d <= sphere.radius * sphere.radius;
}

/// "Real-Time Rendering", 3rd ed., 16.13.1.
template <typename Real>
bool plain_spheres(const PlainSphere<Real>& a, const PlainSphere<Real>& b) {
  const PlainVector<Real> way = difference(a.centre, b.centre);
  const Real reach = a.radius + b.radius;
  return dot(way, way) <= reach * reach;
}

template <typename Real>
PlainSphere<Real> to_plain(const Sphere& sphere) {
  PlainSphere<Real> result;
  for (int i = 0; i < 3; ++i)
    result.centre[i] = static_cast<Real>(sphere.centre.data()[i]);
  result.radius = static_cast<Real>(sphere.radius);
  return result;
}

}  // namespace graze::benchmark
