// What the bundled shapes and poses without a formula of their own are made of: noise, dice,
// circles by halving, spheres of triangles, the way to the first touch, and PLY in all layouts.

#include <gtest/gtest.h>

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "data/generator/approach.h"
#include "data/generator/mesh_writers.h"
#include "data/generator/noise.h"
#include "data/generator/parts/circle.h"
#include "data/generator/parts/geodesic.h"
#include "tests/files/temporary_directory.h"

namespace graze {
namespace {

using namespace generator;
using Eigen::Vector3d;

TEST(GeneratorNoise, IsZeroOnTheLatticeAndNotBeside) {
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(gradient_noise(Vector3d(i - 50, 2 * i, -i), 1), 0);
    largest = std::max(largest, std::abs(gradient_noise(Vector3d(i + 0.4, i + 0.7, 0.3), 1)));
  }
  EXPECT_GT(largest, 0.2);
  EXPECT_LT(largest, 1.5);
}

// Across the border of two cells, also where the whole part changes sign.
TEST(GeneratorNoise, IsContinuousWithItsSlope) {
  const double step = 0x1p-20;
  for (int axis = 0; axis < 3; ++axis) {
    for (int border = -2; border <= 2; ++border) {
      Vector3d at(0.3, 0.6, 0.8);
      const auto along = [&](double x) {
        at[axis] = x;
        return gradient_noise(at, 7);
      };
      const double here = along(border);
      EXPECT_NEAR(along(border - step), here, 4 * step);
      EXPECT_NEAR((here - along(border - step)) / step, (along(border + step) - here) / step, 1e-4);
    }
  }
}

TEST(GeneratorNoise, LayersAreSummed) {
  const Vector3d p(0.3, 1.7, -2.2);
  EXPECT_EQ(fractal_noise(p, {9, 1, 0.5}), gradient_noise(p, 9));
  EXPECT_EQ(fractal_noise(p, {9, 2, 0.5}), gradient_noise(p, 9) + 0.5 * gradient_noise(2 * p, 10));
}

TEST(GeneratorDice, TurnAndPointWithoutPreference) {
  Dice dice(11);
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix3d turned = Eigen::Matrix3d::Zero();
  constexpr int kThrows = 4000;
  for (int i = 0; i < kThrows; ++i) {
    const Vector3d direction = dice.direction();
    EXPECT_NEAR(direction.norm(), 1, 1e-15);
    sum += direction;
    const Eigen::Matrix3d rotation = dice.rotation();
    EXPECT_LT((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(),
              4e-15);
    EXPECT_GT(rotation.determinant(), 0);
    turned += rotation;
    const double number = dice.uniform(-3, 5);
    EXPECT_TRUE(number >= -3 && number < 5);
  }
  // Of n throws the mean is off by some 1 / sqrt(3 n) = 0.009 per coordinate.
  EXPECT_LT((sum / kThrows).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_LT((turned / kThrows).cwiseAbs().maxCoeff(), 0.05);
}

TEST(GeneratorDice, TheSeedSaysWhatComes) {
  Dice dice_a(1), dice_b(1), dice_c(2);
  const double first = dice_a.uniform(0, 1);
  EXPECT_EQ(first, dice_b.uniform(0, 1));
  EXPECT_NE(first, dice_c.uniform(0, 1));
  EXPECT_NE(first, dice_a.uniform(0, 1));
}

TEST(GeneratorCircle, HasEqualStepsAndExactMirrors) {
  const auto circle = unit_circle(4);
  ASSERT_EQ(circle.size(), 64u);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / 64;
    EXPECT_NEAR(circle[i].x, std::cos(angle), 1e-15);
    EXPECT_NEAR(circle[i].y, std::sin(angle), 1e-15);
    EXPECT_EQ(circle[i].x, circle[(64 - i) % 64].x);
    EXPECT_EQ(circle[i].y, -circle[(64 - i) % 64].y);
    EXPECT_EQ(circle[i].x, circle[(80 - i) % 64].y);
  }
}

Mesh mesh_of(const Surface& surface) {
  return Mesh(surface.vertices(), surface.triangles());
}

TEST(GeneratorGeodesicSphere, IsClosedAndRound) {
  for (int frequency : {1, 2, 3, 7}) {
    const Surface sphere = make_geodesic_sphere(frequency);
    const std::size_t triangles = 20 * static_cast<std::size_t>(frequency * frequency);
    EXPECT_EQ(sphere.triangles().size(), triangles);
    EXPECT_EQ(sphere.vertices().size(), triangles / 2 + 2);
    EXPECT_TRUE(mesh_of(sphere).topology().is_closed);
    for (const Vector3d& v : sphere.vertices())
      EXPECT_NEAR(v.norm(), 1, 1e-15);
    for (const auto& [a, b, c] : sphere.triangles()) {
      const auto& v = sphere.vertices();
      EXPECT_GT(v[a].dot(v[b].cross(v[c])), 0);
    }
  }
}

// A tetrahedron with its tip down, above another with its face up.
Mesh tetrahedron(double tip) {
  Surface surface;
  const std::uint32_t a = surface.vertex({-1, -1, 0});
  const std::uint32_t b = surface.vertex({2, -1, 0});
  const std::uint32_t c = surface.vertex({-1, 2, 0});
  const std::uint32_t d = surface.vertex({0, 0, tip});
  surface.triangle(a, b, c);
  surface.triangle(a, b, d);
  surface.triangle(b, c, d);
  surface.triangle(c, a, d);
  return mesh_of(surface);
}

ApproachPair falling_tetrahedra(double sideways) {
  const auto draw = [=](Dice&) -> Approach {
    // The middle of B's bounds is at (0.5, 0.5, -1).
    return {Eigen::Matrix3d::Identity(), {0.5 + sideways, 0.5, 6}, -Vector3d::UnitZ(), 8};
  };
  return {tetrahedron(-2), tetrahedron(-2), 2, draw};
}

TEST(GeneratorApproach, FindsTheFirstTouch) {
  const ApproachPair pair = falling_tetrahedra(0);
  Dice dice(1);
  const Approach drawn = pair.draw(dice);
  const std::optional<double> touch = first_touch(pair, drawn);
  // From z = 5 its tip comes down to z = 0.
  ASSERT_TRUE(touch);
  EXPECT_NEAR(*touch, 5, 1e-11);
  EXPECT_TRUE(intersects({pair.mesh_a}, {pair.mesh_b, at_distance(pair, drawn, *touch)}));
  EXPECT_FALSE(intersects({pair.mesh_a}, {pair.mesh_b, at_distance(pair, drawn, *touch - 1e-11)}));
}

TEST(GeneratorApproach, SeesNoTouchBesideOrFromWithin) {
  Dice dice(1);
  const ApproachPair beside = falling_tetrahedra(4);
  EXPECT_FALSE(first_touch(beside, beside.draw(dice)));
  const ApproachPair within = falling_tetrahedra(0);
  Approach low = within.draw(dice);
  low.start.z() = -1;
  EXPECT_FALSE(first_touch(within, low));
}

TEST(GeneratorApproach, RegimesAreWhatTheySay) {
  const ApproachPair pair = falling_tetrahedra(0);
  Dice dice(1);
  const auto gap = [](const Eigen::Isometry3d& pose) { return pose.translation().z() - 2; };
  const PoseList near = approach(pair, near_regime("near"), dice);
  EXPECT_EQ(near.name, "near");
  EXPECT_EQ(near.poses.size(), 36u);
  for (std::size_t i = 0; i < near.poses.size(); ++i) {
    EXPECT_NEAR(gap(near.poses[i]), (std::array{0.002, 0.02, 0.1}[i % 3]), 1e-10);
  }
  for (const auto& pose : approach(pair, far_regime("far"), dice).poses) {
    EXPECT_TRUE(gap(pose) > 2 && gap(pose) < 8);
  }
  for (const auto& pose : approach(pair, touch_regime("touch"), dice).poses) {
    EXPECT_TRUE(gap(pose) < -0.0019 && gap(pose) > -0.0201);
  }
  for (const auto& pose : approach(pair, deep_regime("deep"), dice).poses) {
    EXPECT_TRUE(gap(pose) < -0.19 && gap(pose) > -1.01);
  }
}

TEST(GeneratorApproach, VainDrawsAreAnError) {
  Dice dice(1);
  EXPECT_THROW(approach(falling_tetrahedra(4), near_regime("near"), dice), std::runtime_error);
}

// g++ 12 leaves the rounding out where it converts there and back in pairs.
double through_float(double value) {
  const volatile float rounded = static_cast<float>(value);
  return rounded;
}

// Doubles come back as they are. Floats are widened from a binary file; in text they are the
// decimals that round to them, of which graze reads the double.
void expect_reads_back(const std::filesystem::path& path, const Surface& surface,
                       const PlyLayout& layout) {
  write_ply(path, surface, layout);
  const Mesh mesh = load_mesh(path);
  EXPECT_TRUE(std::ranges::equal(mesh.triangles(), surface.triangles()));
  ASSERT_EQ(mesh.vertices().size(), surface.vertices().size());
  const bool is_float = layout.coordinates == PlyCoordinates::Float;
  for (std::size_t i = 0; i < mesh.vertices().size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double written = surface.vertices()[i][k];
      const double read = mesh.vertices()[i][k];
      const bool is_text = layout.encoding == PlyEncoding::Ascii;
      EXPECT_EQ(is_float && is_text ? through_float(read) : read,
                is_float ? through_float(written) : written);
    }
  }
}

TEST(GeneratorPly, EveryLayoutReadsBack) {
  const tests::TemporaryDirectory scratch;
  const Surface sphere = make_geodesic_sphere(3);
  for (PlyEncoding encoding :
       {PlyEncoding::Ascii, PlyEncoding::LittleEndian, PlyEncoding::BigEndian}) {
    for (PlyCoordinates coordinates : {PlyCoordinates::Float, PlyCoordinates::Double}) {
      for (PlyIndices indices : {PlyIndices::Ushort, PlyIndices::Uint}) {
        expect_reads_back(scratch.path("sphere.ply"), sphere, {encoding, coordinates, indices});
      }
    }
  }
}

TEST(GeneratorPly, TooManyVerticesForShortIndicesAreRefused) {
  const tests::TemporaryDirectory scratch;
  Surface surface;
  for (int i = 0; i <= 0xffff; ++i)
    surface.vertex({static_cast<double>(i), 0, 0});
  EXPECT_THROW(write_ply(scratch.path("many.ply"), surface, {.indices = PlyIndices::Ushort}),
               std::runtime_error);
}

}  // namespace
}  // namespace graze
