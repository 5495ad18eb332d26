#pragma once

#include <optional>
#include <vector>

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/narrowphase/triangle.h>

namespace graze::compare {

/// True if a point lies on one of the triangles, exactly.
bool is_on_surface(const std::vector<Triangle>& surface, const Eigen::Vector3d& point);

/// True if a closed surface encloses a point that is not on it, by the even-odd rule, exactly. It
/// counts what a ray along +x meets that begins at the point moved by (0, e, e'), where e' is as
/// much smaller than e as is needed: then the ray meets no edge, and comparisons that are strict on
/// one side say which triangles it meets (the rule of half-open edges of point in polygon).
bool is_enclosed(const std::vector<Triangle>& surface, const Eigen::Vector3d& point);

/// Returns one vertex of every part of a mesh that is connected by shared indices.
std::vector<std::uint32_t> one_of_each_part(const Mesh& mesh);

}  // namespace graze::compare
