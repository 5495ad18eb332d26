#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace graze::narrowphase {

/// Holds the triangles around a vertex. Triangle i has the vertex and the ends of `rays[i]` and
/// `rays[i + 1]`, and if the fan is closed, one more has those of the last ray and the first.
struct VertexFan {
  static constexpr std::size_t kMostRays = 128;
  enum class Kind { Open, Closed };

  const Eigen::Vector3d* vertex;
  std::span<const Eigen::Vector3d* const> rays;  ///< two to kMostRays rays
  Kind kind;
};

/// True only if any two triangles of the fan have no more in common than the vertex and, if one
/// follows the other, the edge between them. It computes in rounded arithmetic, for any finite
/// points; false is not sure. Takes linear time.
bool is_surely_simple(const VertexFan& fan);

}  // namespace graze::narrowphase
