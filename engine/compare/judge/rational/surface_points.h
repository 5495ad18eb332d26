#pragma once

#include <vector>

#include <graze/engine/compare/judge/rational/mesh_referee.h>

namespace graze::compare {

/// How far a point is from the nearest of some triangles: exact, and rounded once.
double distance_to(const std::vector<Triangle>& surface, const Eigen::Vector3d& point);

/// The largest absolute coordinate of all placed triangles.
double largest_coordinate(const MeshReferee& referee);

/// How far B must be moved along a unit vector until a plane across it parts the two; negative if
/// one does already. In double, off by some ulp of the largest coordinate.
double overlap_along(const MeshReferee& referee, const Eigen::Vector3d& normal);

}  // namespace graze::compare
