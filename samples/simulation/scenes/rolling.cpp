#include "samples/simulation/scenes/rolling.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "samples/simulation/scenes/parts.h"

namespace graze::samples {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.5, kWay = 100;  // metres, the ball's radius and the way that it rolls
// Contact points are parts of the bodies until the world finds others: within a step they leave the
// ground with a surface that rolls. So there are no substeps.
constexpr int kSubsteps = 1;
constexpr double kWheel = 0.3, kKerb = 0.02, kWheelSpeed = 3;  // metres, m/s

/// Returns a strip at z = 0 of squares in two triangles each, along diagonals and with corners at
/// random.
Mesh plane_of_triangles(double from, double to, double half_width, double edge) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const auto columns = static_cast<std::uint32_t>(std::lround((to - from) / edge));
  const auto rows = static_cast<std::uint32_t>(std::lround(2 * half_width / edge));
  std::vector<Vector3d> vertices;
  for (std::uint32_t i = 0; i <= columns; ++i) {
    for (std::uint32_t j = 0; j <= rows; ++j) {
      vertices.emplace_back(from + edge * (i + uniform(-0.3, 0.3)),
                            -half_width + edge * (j + uniform(-0.3, 0.3)), 0);
    }
  }
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < columns; ++i) {
    for (std::uint32_t j = 0; j < rows; ++j) {
      const std::uint32_t a = i * (rows + 1) + j, b = a + rows + 1, c = b + 1, d = a + 1;
      if (uniform(0, 1) < 0.5) {
        triangles.push_back({a, b, c}), triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d}), triangles.push_back({b, c, d});
      }
    }
  }
  return {vertices, std::span<const TriangleIndices>(triangles)};
}

}  // namespace

Scene rolling_ball(Surface ground, Extent extent) {
  Scene scene{.name = std::string("ball.rolls.") + name_of(ground),
              .bodies = {},
              .outcome = Outcome::Moves,
              .substeps = kSubsteps};
  const double seconds = extent == Extent::Small ? 4 : 40, speed = kWay / seconds;
  scene.steps = static_cast<int>(std::lround(seconds / scene.step));
  scene.bodies.push_back(floor_of(Surface::Analytic));
  scene.bodies.back().shape = Box{{kWay / 2 + 3, 3, 0.25}};
  scene.bodies.back().pose = at({kWay / 2, 0, -0.25});
  if (ground == Surface::Mesh) {
    scene.bodies.back().shape = plane_of_triangles(-3, kWay + 3, 3, 0.4);
    scene.bodies.back().pose = Pose::Identity();
  }
  scene.bodies.push_back({.name = "ball",
                          .shape = Sphere{{0, 0, 0}, kRadius},
                          .pose = at({0, 0, kRadius}),
                          .velocity = {speed, 0, 0},
                          .spin = {0, speed / kRadius, 0}});
  return scene;
}

Roll roll(const Scene& scene) {
  SceneRun run(scene);
  const RigidBody& ball = run.bodies().back();
  const Vector3d start = ball.at;
  const double speed = ball.velocity.x();
  Roll result;
  for (int i = 0; i < scene.steps; ++i) {
    run.step();
    result.aside = std::max(result.aside, std::abs(ball.at.y() - start.y()));
    result.height = std::max(result.height, std::abs(ball.at.z() - start.z()));
  }
  result.distance = ball.at.x() - start.x();
  result.slower = 1 - ball.velocity.x() / speed;
  result.unrolled = std::abs(ball.velocity.x() - kRadius * ball.spin.y()) / speed;
  return result;
}

Scene wheel_over_kerb(Surface surface, Extent extent) {
  Scene scene{.name = std::string("wheel.kerb.") + name_of(surface),
              .bodies = {floor_of(surface)},
              .outcome = Outcome::Moves,
              .steps = 150,
              .substeps = kSubsteps};
  scene.bodies[0].friction = 1;
  scene.bodies.push_back({.name = "kerb",
                          .shape = as(surface, Box{{1.2, 1, kKerb / 2}}),
                          .pose = at({1.8, 0, kKerb / 2}),
                          .hold = Hold::Fixed,
                          .friction = 1});
  Pose upright = at({-0.3, 0, kWheel});
  upright.linear() << 0, 1, 0, 0, 0, 1, 1, 0, 0;  // the wheel's axis lies along y
  // At each edge a prism that rolls loses 2/3 (1 - cos of a sector's angle) of its speed: 3 percent
  // in all the way with 720.
  const int sectors = extent == Extent::Small ? 720 : 1440;
  scene.bodies.push_back({.name = "wheel",
                          .shape = as(surface, Cylinder{kWheel, 0.1}, {.sectors = sectors}),
                          .pose = upright,
                          .friction = 1,
                          .velocity = {kWheelSpeed, 0, 0},
                          .spin = {0, kWheelSpeed / kWheel, 0}});
  return scene;
}

// About the kerb's edge the wheel keeps its moment of momentum: v r / 2 + v (r - h) per mass
// before, 3/2 r^2 spin afterwards. Then its centre rises by h.
double speed_beyond_kerb() {
  const double spin = kWheelSpeed * (kWheel / 2 + kWheel - kKerb) / (1.5 * kWheel * kWheel);
  return std::sqrt(spin * spin * kWheel * kWheel - 2 * 9.81 * kKerb / 1.5);
}

}  // namespace graze::samples
