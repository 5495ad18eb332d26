#include "tests/shapes/random_meshes.h"

#include <Eigen/Geometry>
#include <vector>

namespace graze::tests {

Mesh random_soup(const SoupSettings& settings, RandomSource& source) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < settings.count; ++i) {
    const Eigen::Vector3d centre =
        settings.centre + source.vector(-settings.extent, settings.extent);
    for (int k = 0; k < 3; ++k)
      vertices.push_back(centre + source.vector(-1, 1) * settings.size);
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2 - (i % 10 == 0)});
  }
  return Mesh(vertices, triangles);
}

Mesh lattice_soup(std::size_t count, int extent, RandomSource& source) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k)
      vertices.push_back(source.lattice_point(-extent, extent));
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return Mesh(vertices, triangles);
}

Pose random_pose(double reach, RandomSource& source) {
  Pose pose = Pose::Identity();
  const Eigen::Vector3d axis = source.vector(-1, 1);
  pose.linear() = Eigen::AngleAxisd(source.uniform(-3, 3), axis.normalized()).toRotationMatrix();
  pose.translation() = source.vector(-1, 1) * reach;
  return pose;
}

Pose distorted(Pose pose, double deviation, RandomSource& source) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      pose.linear()(i, j) += source.uniform(-1, 1) * deviation / 4;
  }
  return pose;
}

}  // namespace graze::tests
