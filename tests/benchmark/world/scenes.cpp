#include <graze/engine/mesh/load_mesh.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "samples/simulation/bin.h"
#include "tests/benchmark/world/scene.h"

namespace graze::benchmark {
namespace {

constexpr double kDensity = 2000;  // kg/m^3

samples::MassProperties solid(double volume, const Eigen::Vector3d& squares) {
  samples::MassProperties result{kDensity * volume, Eigen::Vector3d::Zero(), {}, {}};
  result.inertia = (result.mass * squares).asDiagonal();
  result.inverse_inertia = result.inertia.inverse();
  return result;
}

Kind ball(double r) {
  const double square = 0.4 * r * r;
  return {Sphere{Eigen::Vector3d::Zero(), r},
          solid(4.18879020478639 * r * r * r, Eigen::Vector3d::Constant(square)), r};
}

Kind box(const Eigen::Vector3d& half) {
  const Eigen::Vector3d s = half.cwiseProduct(half) / 3;
  return {Box{half}, solid(8 * half.prod(), {s.y() + s.z(), s.x() + s.z(), s.x() + s.y()}),
          half.norm()};
}

Kind part(const std::filesystem::path& file) {
  const Mesh mesh = load_mesh(file);
  Kind kind{mesh, samples::mass_properties(mesh, 7850), 0};
  for (const Eigen::Vector3d& vertex : mesh.vertices())
    kind.bounding_radius = std::max(kind.bounding_radius, (vertex - kind.mass.centre).norm());
  return kind;
}

/// The bundled terrain, as wide as that.
Mesh terrain(const std::string& data, double width) {
  const Mesh mesh = load_mesh(data + "/meshes/terrain.ply");
  const Aabb& bounds = mesh.bounds();
  const double scale = width / (bounds.max - bounds.min).head<2>().maxCoeff();
  const Eigen::Vector3d middle = 0.5 * (bounds.min + bounds.max);
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3d& vertex : mesh.vertices())
    vertices.emplace_back(scale * (vertex - middle));
  return Mesh(vertices, {mesh.triangles().begin(), mesh.triangles().end()});
}

}  // namespace

Scene make_pile(std::size_t count, const std::string& data) {
  const double radius = 0.08 * std::sqrt(static_cast<double>(count));
  Scene scene{"pile", terrain(data, 5 * radius), {}, {}, (count + 9) / 10, radius, 0.5};
  std::mt19937_64 random(1);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int i = 0; i < 16; ++i) {
    scene.kinds.push_back(box({uniform(0.08, 0.2), uniform(0.08, 0.2), uniform(0.08, 0.2)}));
    scene.kinds.push_back(ball(uniform(0.1, 0.2)));
  }
  for (std::size_t i = 0; i < count; ++i)
    scene.bodies.push_back(random() % scene.kinds.size());
  return scene;
}

Scene make_pour(std::size_t count, const std::string& data) {
  const double scale = std::cbrt(static_cast<double>(count) / 200);
  samples::BinSize size;
  size.floor_radius *= scale, size.mouth_radius *= scale, size.height *= scale;
  Scene scene{"pour", samples::make_bin(size), {}, {}, 0, 0.8 * size.floor_radius, 0.3};
  scene.kinds = {part(data + "/meshes/bolt.obj"), part(data + "/meshes/nut.stl")};
  const double bounding_radius =
      std::max(scene.kinds[0].bounding_radius, scene.kinds[1].bounding_radius);
  scene.layer = static_cast<std::size_t>(
      std::max(1.0, 0.6 * scene.radius * scene.radius / (bounding_radius * bounding_radius)));
  for (std::size_t i = 0; i < count; ++i)
    scene.bodies.push_back(i % 2);
  return scene;
}

}  // namespace graze::benchmark
