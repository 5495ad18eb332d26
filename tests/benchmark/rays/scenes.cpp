#include "tests/benchmark/rays/scenes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <utility>

#include "tests/shapes/random_source.h"

namespace graze::benchmark {
namespace {

using Eigen::Vector3d;

}  // namespace

Mesh bumpy_ball(std::uint32_t triangles) {
  const auto rings = static_cast<std::uint32_t>(std::sqrt(triangles / 4.0));
  const std::uint32_t around = 2 * rings;
  std::vector<Vector3d> vertices;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const double polar = std::numbers::pi * i / rings;
    for (std::uint32_t j = 0; j < around; ++j) {
      const double turn = 2 * std::numbers::pi * j / around;
      const Vector3d n(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                       std::cos(polar));
      const double bumps = 0.08 * std::sin(9 * n.x()) * std::sin(7 * n.y() + 1) +
                           0.02 * std::sin(41 * n.z()) * std::sin(37 * n.x()) +
                           0.004 * std::sin(173 * n.y()) * std::sin(151 * n.z());
      vertices.push_back(n * (1 + bumps));
    }
  }
  std::vector<TriangleIndices> indices;
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const std::uint32_t a = i * around + j, b = i * around + (j + 1) % around;
      const std::uint32_t c = a + around, d = b + around;
      indices.push_back({a, c, b});
      indices.push_back({b, c, d});
    }
  }
  RandomSource source(5);
  for (std::size_t i = indices.size() - 1; i > 0; --i)
    std::swap(indices[i],
              indices[static_cast<std::size_t>(source.uniform(0, static_cast<double>(i + 1)))]);
  return {vertices, indices};
}

std::vector<Ray> coherent_rays(const Mesh& mesh, std::size_t count) {
  const Vector3d centre = 0.5 * (mesh.bounds().min + mesh.bounds().max);
  const double size = (mesh.bounds().max - mesh.bounds().min).norm();
  const Vector3d eye = centre + size * Vector3d(0.4, 0.5, 1.2);
  const Vector3d ahead = (centre - eye).normalized();
  const Vector3d right = ahead.cross(Vector3d::UnitY()).normalized();
  const Vector3d up = right.cross(ahead);
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count))) / 8 * 8;
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < side * side; ++i) {
    const std::size_t block = i / 64, in_block = i % 64;
    const std::size_t x = block % (side / 8) * 8 + in_block % 8;
    const std::size_t y = block / (side / 8) * 8 + in_block / 8;
    const double u = (static_cast<double>(x) + 0.5) / static_cast<double>(side) - 0.5;
    const double v = (static_cast<double>(y) + 0.5) / static_cast<double>(side) - 0.5;
    rays.push_back({eye, ahead + 0.6 * (u * right + v * up)});
  }
  return rays;
}

std::vector<Ray> random_rays(const Mesh& mesh, std::size_t count) {
  const Vector3d low = mesh.bounds().min, high = mesh.bounds().max;
  const Vector3d centre = 0.5 * (low + high);
  const double radius = (high - low).norm();
  RandomSource source(7);
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const Vector3d from = source.vector(-1, 1);
    if (from.norm() > 1 || from.norm() < 0.1) continue;
    const Vector3d within = low + (high - low).cwiseProduct(source.vector(0, 1));
    const Vector3d origin = centre + from.normalized() * radius;
    rays.push_back({origin, within - origin});
  }
  return rays;
}

}  // namespace graze::benchmark
