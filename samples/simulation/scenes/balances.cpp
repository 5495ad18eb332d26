#include "samples/simulation/scenes/balances.h"

#include <array>
#include <cmath>
#include <numbers>

#include "samples/simulation/scenes/parts.h"

namespace graze::samples {
namespace {

using Eigen::Vector3d;
constexpr double kFriction = 0.8;

void put(Scene& scene, const std::string& name, const Shape& shape, const Pose& pose) {
  scene.bodies.push_back({.name = name + std::to_string(scene.bodies.size()),
                          .shape = shape,
                          .pose = pose,
                          .friction = kFriction});
}

Scene empty(const std::string& name, Surface surface) {
  Scene scene{.name = name + "." + name_of(surface),
              .bodies = {floor_of(surface)},
              .outcome = Outcome::Shown};
  scene.bodies.front().friction = kFriction;
  return scene;
}

/// Adds two cards that lean on each other, with their upper edges at x and their lower ones at z.
void lean(Scene& scene, Surface surface, double x, double z) {
  constexpr double kHalf = 0.5, kThick = 0.01, kLean = 0.3;  // metres, metres, radians
  for (const double side : {-1, 1}) {
    // The lowest edge of a card that leans is below its middle by half of it and of its thickness.
    const double up = kHalf * std::cos(kLean) + kThick * std::sin(kLean);
    const double out = kHalf * std::sin(kLean) + kThick * std::cos(kLean);
    put(scene, "card", as(surface, Box{{kThick, 0.35, kHalf}}),
        at({x + side * out, 0, z + up}, -side * kLean, Vector3d::UnitY()));
  }
}

Scene card_house(Surface surface) {
  Scene scene = empty("card_house", surface);
  const double storey = 2 * (0.5 * std::cos(0.3) + 0.01 * std::sin(0.3));
  const double apart = 0.7;
  for (const double x : {-apart / 2, apart / 2})
    lean(scene, surface, x, 0);
  put(scene, "roof", as(surface, Box{{0.5, 0.35, 0.01}}), at({0, 0, storey + 0.01}));
  lean(scene, surface, 0, storey + 0.02);
  return scene;
}

/// Builds half a ring of wedges between two radii, the outermost standing on the floor.
Scene arch(Surface surface) {
  Scene scene = empty("arch", surface);
  constexpr int kWedges = 9;
  constexpr double kInner = 0.8, kOuter = 1.1;
  const double wide = std::numbers::pi / kWedges;
  for (int i = 0; i < kWedges; ++i) {
    const double middle = wide * (i + 0.5);
    std::vector<Vector3d> corners;
    for (const double radius : {kInner, kOuter}) {
      for (const double side : {-0.5, 0.5}) {
        const double angle = middle + side * wide;
        for (const double y : {-0.2, 0.2})
          corners.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
      }
    }
    put(scene, "wedge", as(surface, ConvexHull(corners)), Pose::Identity());
  }
  return scene;
}

}  // namespace

std::vector<Scene> balances(Surface surface) {
  return {card_house(surface), arch(surface)};
}

}  // namespace graze::samples
