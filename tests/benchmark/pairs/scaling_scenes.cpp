#include "data/generator/noise.h"
#include "data/generator/parts/geodesic.h"
#include "tests/benchmark/common/pose_regimes.h"
#include "tests/benchmark/pairs/scene.h"

namespace graze::benchmark {
namespace {

/// The same rock at every frequency, a metre in radius: 20 * frequency^2 triangles.
Mesh rock(int frequency) {
  constexpr generator::Fractal kShape{.seed = 3, .layers = 5, .gain = 0.45};
  const generator::Surface sphere = generator::make_geodesic_sphere(frequency);
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3d& u : sphere.vertices())
    vertices.emplace_back(u * (1 + 0.25 * generator::fractal_noise(1.7 * u, kShape)));
  return Mesh(vertices, sphere.triangles());
}

Scene scene_of(int frequency, std::size_t poses) {
  const Mesh mesh = rock(frequency);
  Scene scene{"scaling", "rock, " + std::to_string(mesh.triangles().size()), mesh, mesh, {}};
  for (const Regime regime : kRegimes) {
    if (regime == Regime::Far) continue;
    scene.regimes.push_back(
        {name_of(regime), "generated", poses_in(regime, mesh, mesh, {.count = poses})});
  }
  return scene;
}

}  // namespace

std::vector<SceneMaker> scaling_scenes(const SceneSettings& settings) {
  constexpr std::size_t kFirst = 7;  // 980 triangles
  std::vector<SceneMaker> scenes;
  for (std::size_t n = kFirst; 20 * n * n <= settings.most_triangles * 11 / 10; n *= 2) {
    scenes.emplace_back([frequency = static_cast<int>(n), poses = settings.poses] {
      return scene_of(frequency, poses);
    });
  }
  return scenes;
}

}  // namespace graze::benchmark
