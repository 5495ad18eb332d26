#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace graze::tests {

using Points = std::vector<Eigen::Vector3d>;

struct PointSet {
  std::string name;
  Points points;
};

/// Shapes about one metre across: random, on lattices, duplicate, flat, straight, cocircular,
/// cospherical, nearly so, and few.
std::vector<PointSet> plain_sets();

/// The plain sets, and all of them moved far away, made thin, huge and tiny down to denormals.
std::vector<PointSet> hard_sets();

Points scaled(Points points, double factor);

Points moved(Points points, const Eigen::Vector3d& offset);

}  // namespace graze::tests
