#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace graze::generator {

/// Triangles under construction. Equal positions are one vertex, so that parts which are built with
/// the same coordinates along a common border close up. The unit is the caller's.
class Surface {
 public:
  using Indices = std::array<std::uint32_t, 3>;

  /// The index of the vertex at this position, new or known.
  std::uint32_t vertex(const Eigen::Vector3d& position);

  /// Adds a triangle, counter-clockwise seen from outside, unless two of its corners are one
  /// vertex: a strip that runs into a pole collapses there.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  /// Adds the quadrangle a b c d, split along a c.
  void quadrangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);

  /// The same surface with every coordinate multiplied by `factor`.
  Surface scaled(double factor) const;

  const std::vector<Eigen::Vector3d>& vertices() const { return vertices_; }
  const std::vector<Indices>& triangles() const { return triangles_; }

 private:
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Indices> triangles_;
  std::map<std::array<double, 3>, std::uint32_t> index_of_;
};

}  // namespace graze::generator
