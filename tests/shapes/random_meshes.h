#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// Triangles that have nothing to do with each other, within a cube of half size `extent` around
/// `centre`, each about `size` across; a tenth of them degenerate.
struct SoupSettings {
  std::size_t count = 60;
  double extent = 1;  // metres
  double size = 0.3;  // metres
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};
Mesh random_soup(const SoupSettings& settings, RandomSource& source);

/// Triangles with corners on a small lattice: many coplanar, touching, degenerate and equal.
Mesh lattice_soup(std::size_t count, int extent, RandomSource& source);

/// A rotation as rounding leaves it, with translations up to `reach` metres.
Pose random_pose(double reach, RandomSource& source);

/// The pose with its rotation distorted by about `deviation`, as drift would.
Pose distorted(Pose pose, double deviation, RandomSource& source);

}  // namespace graze::tests
