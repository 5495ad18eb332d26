#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <graze/engine/cases/case.h>

namespace graze::cli {

/// A part of a shape as it is drawn.
struct Outline {
  std::vector<Eigen::Vector3d> points;
  bool is_silhouette = false;  ///< the convex hull of the points as they are seen; else a polygon
  std::string colour = {};
};

/// Of each mesh no more triangles than this are drawn.
inline constexpr std::size_t kMostTrianglesDrawn = 200;

/// The two shapes of a case, A before B: triangles one by one, of which the first of each mesh are
/// enough, a half-space as a piece of its plane near the other shape, and of all others points on
/// their surface.
std::vector<Outline> case_outlines(const Case& query);

}  // namespace graze::cli
