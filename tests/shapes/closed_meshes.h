#pragma once

#include <graze/engine/mesh/mesh.h>
#include <cstddef>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// Tetrahedra that go through one another, with corners at random: a closed mesh by the even-odd
/// rule.
Mesh random_tetrahedra(std::size_t count, double extent, RandomSource& source);

/// The same with corners on a small lattice: some flat, touching, coplanar or equal.
Mesh lattice_tetrahedra(std::size_t count, int extent, RandomSource& source);

/// The mesh with every vertex p moved to p * scale + offset, rounded.
Mesh mapped(const Mesh& mesh, double scale, const Eigen::Vector3d& offset);

}  // namespace graze::tests
