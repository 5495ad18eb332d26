#pragma once

#include <graze/bvh/obb.h>
#include <Eigen/Core>
#include <span>

namespace graze {

// The fits throw InputError for no points, for the first that is not finite, and for points so
// far apart that a half extent overflows. The boxes contain the points in both readings of a box:
// each point is t + R y with y in [-h, h] in exact arithmetic, and its coordinates as law 3 rounds
// them lie in [-h, h]. The rotation deviates from an exact one by a few 1e-16, which costs the half
// extents a few ulp of their sum; a box along the coordinate axes costs none of it.

/// Returns the box along the axes of the points' covariance (Gottschalk, Lin, Manocha, "OBBTree",
/// 1996), in linear time. Many points in one place pull the axes towards it.
Obb covariance_box(std::span<const Eigen::Vector3d> points);

/// Returns the box of DiTO-14, or the box along the coordinate axes where that has less surface.
/// DiTO-14 takes axes from the edges of two tetrahedra over a large triangle of extremal points
/// (Larsson, Källberg, "Fast computation of tight-fitting oriented bounding boxes", Game Engine
/// Gems 2, 2011). It is linear, and fast.
Obb ditetrahedron_box(std::span<const Eigen::Vector3d> points);

/// Returns the smallest by volume of three boxes that are refined: the two above and the box along
/// the coordinate axes, each turned about its own axes to the smallest rectangle around the points'
/// shadow, until that gains nothing. The volume counts with a billionth of the size added to each
/// extent, so that flat sets get the least area and straight ones the least length. Each turn takes
/// O(n log n). What it finds is a local minimum. It is meant for boxes of whole meshes rather than
/// for each node of a tree.
Obb bounding_obb(std::span<const Eigen::Vector3d> points);

/// Returns a box around both, rounded outward: the tight box of their corners, with a margin for
/// how the corners and the coordinates by law 3 round. Throws InputError or PoseError for a box
/// that is not valid.
Obb merged(const Obb& box_a, const Obb& box_b);

}  // namespace graze
