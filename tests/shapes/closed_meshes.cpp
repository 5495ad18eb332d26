#include "tests/shapes/closed_meshes.h"

#include <cstdint>
#include <vector>

namespace graze::tests {
namespace {

template <typename MakePoint>
Mesh tetrahedra(std::size_t count, MakePoint&& make_point) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::size_t n = 0; n < count; ++n) {
    const auto i = static_cast<std::uint32_t>(vertices.size());
    for (int k = 0; k < 4; ++k)
      vertices.push_back(make_point());
    triangles.insert(
        triangles.end(),
        {{i, i + 1, i + 2}, {i + 1, i, i + 3}, {i + 2, i + 1, i + 3}, {i, i + 2, i + 3}});
  }
  return Mesh(vertices, triangles);
}

}  // namespace

Mesh random_tetrahedra(std::size_t count, double extent, RandomSource& source) {
  return tetrahedra(count, [&] { return source.vector(-extent, extent); });
}

Mesh lattice_tetrahedra(std::size_t count, int extent, RandomSource& source) {
  return tetrahedra(count, [&] { return source.lattice_point(-extent, extent); });
}

Mesh mapped(const Mesh& mesh, double scale, const Eigen::Vector3d& offset) {
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3d& p : mesh.vertices())
    vertices.push_back(p * scale + offset);
  return Mesh(vertices, mesh.triangles());
}

}  // namespace graze::tests
