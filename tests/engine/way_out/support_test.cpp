// Law 15 as a body that rests needs it: what lies on flat ground is held on all sides of its
// middle, wherever it lies on the triangles and by whatever hair it leans.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;

constexpr double kWide = 0.13, kTall = 0.1, kDepth = 1e-3;

/// The square from -1 to 1 on the plane z = 0, in so many cells a side of two triangles each.
Mesh ground(std::uint32_t cells) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i <= cells; ++i) {
    for (std::uint32_t j = 0; j <= cells; ++j)
      vertices.emplace_back(2.0 * i / cells - 1, 2.0 * j / cells - 1, 0);
  }
  for (std::uint32_t i = 0; i < cells; ++i) {
    for (std::uint32_t j = 0; j < cells; ++j) {
      const std::uint32_t k = i * (cells + 1) + j;
      triangles.push_back({k, k + cells + 1, k + cells + 2});
      triangles.push_back({k, k + cells + 2, k + 1});
    }
  }
  return {vertices, triangles};
}

/// How far the contacts reach at least, from the point, in any direction along the ground; negative
/// if the point is beside them.
double support_around(const Manifold& manifold, const Vector3d& point) {
  constexpr int kDirections = 360;
  double least = kWide;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const Vector3d direction(std::cos(angle), std::sin(angle), 0);
    double farthest = -kWide;
    for (const ShapeContact& contact : manifold)
      farthest = std::max(farthest, direction.dot(contact.point - point));
    least = std::min(least, farthest);
  }
  return least;
}

std::vector<Shape> bodies() {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? kWide : -kWide, (i & 2) != 0 ? kWide : -kWide,
                         (i & 4) != 0 ? kTall : -kTall);
  }
  return {Box{{kWide, kWide, kTall}}, ConvexHull(corners), Cylinder{kWide, kTall},
          Cone{kWide, kTall}};
}

TEST(WayOut, Law15FlatGroundHoldsABodyOnAllSidesOfItsMiddle) {
  RandomSource source(2911);
  // A square in a circle reaches half of its side, less what leaning by kSteepest takes away.
  constexpr double kSteepest = 1e-4, kLeast = 0.35 * kWide;
  for (const std::uint32_t cells : {1u, 5u, 20u}) {
    const Mesh mesh = ground(cells);
    for (const Shape& body : bodies()) {
      for (const double lean : {0.0, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, kSteepest}) {
        for (int n = 0; n < 12; ++n) {
          Pose pose = Pose::Identity();
          const Vector3d axis = source.vector(-1, 1);
          pose.linear() =
              Eigen::AngleAxisd(lean * source.uniform(-1, 1), axis.normalized()).toRotationMatrix();
          pose.translation() =
              Vector3d{source.uniform(-0.8, 0.8), source.uniform(-0.8, 0.8), kTall - kDepth};
          const Manifold manifold = find_contacts({mesh}, {body, pose});
          EXPECT_GE(support_around(manifold, pose.translation()), kLeast)
              << name_of(body.kind()) << " on " << cells << " cells, leaning by " << lean << ", at "
              << pose.translation().transpose();
        }
      }
    }
  }
}

}  // namespace
}  // namespace graze
