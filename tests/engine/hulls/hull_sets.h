#pragma once

// Points whose hulls are hard: of every thinness, with faces nearly in line, of every scale.

#include <Eigen/Core>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::tests {

enum class HullSet {
  Slab,          ///< at random in [-1, 1]^2 x [-t, t]
  RaisedCentre,  ///< a cube with a point above the middle of its top
  FlatBall,      ///< on an ellipsoid of height t
  Lattice,       ///< small integers, flattened by t
  Needle,        ///< in [-1, 1] x [-t, t]^2
  Dome,          ///< a paraboloid of height t over a lattice
  ShakenBox,     ///< the corners of a box and points on its edges, each off by up to t
  Wedge,         ///< two large triangles that meet at an angle of t
};
inline constexpr int kHullSets = 8;

/// About ten points of a size of about one.
std::vector<Eigen::Vector3d> hull_points(HullSet set, double t, RandomSource& source);

/// 1 to 1e-16, and now and then down to 1e-200.
double random_thinness(RandomSource& source);

/// Turned at random.
void turn(std::vector<Eigen::Vector3d>& points, RandomSource& source);

/// p * scale + shift.
void move(std::vector<Eigen::Vector3d>& points, double scale, const Eigen::Vector3d& shift);

}  // namespace graze::tests
