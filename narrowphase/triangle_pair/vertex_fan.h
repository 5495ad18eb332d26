#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace graze::narrowphase {

/// The triangles around a vertex, each with the next ray of the one before: from the vertex to
/// `rays[i]` and `rays[i + 1]`, and if it is closed, from the last ray to the first.
struct VertexFan {
  static constexpr std::size_t kMostRays = 128;
  enum class Kind { Open, Closed };

  const Eigen::Vector3d* vertex;
  std::span<const Eigen::Vector3d* const> rays;  ///< two to kMostRays
  Kind kind;
};

/// True only if any two triangles of the fan have no more in common than the vertex and, if one
/// follows the other, the edge between them. Rounded, for any finite points; false is not sure.
/// Linear time.
bool is_surely_simple(const VertexFan& fan);

}  // namespace graze::narrowphase
