#pragma once

// Bodies as meshes of any fineness, for the laws of contacts.

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/world/shape.h>

#include <array>
#include <span>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// A box around the origin with `cells` by `cells` squares on each face, two triangles each.
Mesh tessellated_box(const Eigen::Vector3d& half_extents, int cells);

/// A profile of radii and heights, ascending, turned about z in so many steps; closed where it
/// begins and ends on the axis. `stretch` are factors of x and y.
using ProfilePoint = std::array<double, 2>;  // radius, height, metres
Mesh turned_profile(std::span<const ProfilePoint> profile, int sectors,
                    const std::array<double, 2>& stretch);

/// The surface of a set of cubes of a grid, each square cut into `cells` by `cells`, along
/// diagonals at random. Cube (i, j, k) begins at (i, j, k) times the edge.
using Cube = std::array<int, 3>;
Mesh surface_of_cubes(std::span<const Cube> cubes, double edge, int cells, RandomSource& source);

/// A closed convex mesh of the kind, of about 0.4 to 1 m, finer with `fineness`, from 0 on.
enum class ConvexMeshKind { Box, Ball, Prism, Cone };
inline constexpr std::array kConvexMeshKinds = {ConvexMeshKind::Box, ConvexMeshKind::Ball,
                                                ConvexMeshKind::Prism, ConvexMeshKind::Cone};
Mesh convex_mesh(ConvexMeshKind kind, int fineness, RandomSource& source);

/// How far a placed shape, no half-space, reaches along a unit direction, metres from the origin.
double reach_of(const Shape& shape, const Pose& pose, const Eigen::Vector3d& way);

}  // namespace graze::tests
