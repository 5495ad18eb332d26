#include <graze/engine/world/height_field.h>

#include <cmath>

#include "tests/benchmark/height_fields/contestant.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze::benchmark {

namespace {

constexpr int kFrames = 24;

double height_at(double x, double y) {
  return 4 * std::sin(0.05 * x) + 3 * std::cos(0.07 * y) + 0.4 * std::sin(0.9 * x + 0.3 * y);
}

}  // namespace

Terrain make_terrain(std::uint32_t side, std::size_t bodies, std::size_t rays) {
  RandomSource source(1);
  Terrain terrain;
  terrain.side = side;
  for (std::uint32_t r = 0; r < side; ++r) {
    for (std::uint32_t c = 0; c < side; ++c)
      terrain.heights.push_back(static_cast<float>(height_at(c, r) + source.uniform(0, 0.1)));
  }
  const double end = side - 1.0;
  terrain.frames.resize(kFrames);
  for (std::size_t i = 0; i < bodies; ++i) {
    const bool is_ball = i % 2 == 0;
    terrain.bodies.push_back(is_ball ? Shape(Sphere{{0, 0, 0}, 0.5}) : Shape(Box{{0.6, 0.4, 0.3}}));
    Pose pose = is_ball ? Pose::Identity() : tests::random_pose(0, source);
    Eigen::Vector3d at{source.uniform(2, end - 2), source.uniform(2, end - 2), 0};
    const Eigen::Vector3d way{source.uniform(-0.03, 0.03), source.uniform(-0.03, 0.03), 0};
    for (auto& frame : terrain.frames) {
      at += way;
      at.z() = height_at(at.x(), at.y()) + 0.35;
      pose.translation() = at;
      frame.push_back(pose);
    }
  }
  for (std::size_t i = 0; i < rays; ++i) {
    const Eigen::Vector3d from{source.uniform(0, end), source.uniform(0, end), 30};
    const Eigen::Vector3d to{from.x() + source.uniform(-60, 60), from.y() + source.uniform(-60, 60),
                             -10};
    terrain.rays.push_back({from, to - from, (to - from).norm()});
  }
  return terrain;
}

}  // namespace graze::benchmark
