#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <graze/engine/cases/case.h>

namespace graze::cli {

/// Holds a part of a shape as it is drawn.
struct Outline {
  std::vector<Eigen::Vector3d> points;
  bool is_silhouette = false;  ///< true for the convex hull of the points as they are seen, false
                               ///< for a polygon
  std::string colour = {};
};

/// No more triangles of each mesh than this are drawn.
inline constexpr std::size_t kMostTrianglesDrawn = 200;

/// Returns the two shapes of a case, A before B: triangles one by one, of which the first of each
/// mesh are enough, a half-space as a piece of its plane near the other shape, and all other shapes
/// as points on their surface.
std::vector<Outline> case_outlines(const Case& query);

}  // namespace graze::cli
