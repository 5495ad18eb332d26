// The walk of a cast of meshes: on every SIMD target it leaves out nothing that each pair of
// triangles, asked alone, is met sooner in. Where things pass each other by nothing, are far apart,
// or of very different sizes, bounds are as tight as rounding lets them be.

#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/cast.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

struct WalkQuestion {
  PlacedMesh a;
  PlacedMesh b;
  Eigen::Vector3d displacement;
};

/// The least time of all pairs, beyond 1 if none meets.
double each_alone(const WalkQuestion& q) {
  const auto all = [](const PlacedMesh& placed) {
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < placed.mesh.triangles().size(); ++i)
      triangles.push_back(place(placed.pose, placed.mesh.triangle(i)));
    return triangles;
  };
  const std::vector<Triangle> of_b = all(q.b);
  double earliest = 2;
  for (const Triangle& a : all(q.a)) {
    for (const Triangle& b : of_b) {
      if (const auto met = cast(a, b, q.displacement)) earliest = std::min(earliest, met->time);
    }
  }
  return earliest;
}

void expect_earliest(const WalkQuestion& q, const std::vector<std::int64_t>& targets, int number) {
  const double right = each_alone(q);
  for (const std::int64_t target : targets) {
    narrowphase::force_simd_target(target);
    const auto found = cast(q.a, q.b, q.displacement);
    ASSERT_EQ(found.has_value(), right <= 1) << number << " on " << target;
    if (!found) continue;
    EXPECT_EQ(found->time, right) << number << " on " << target;
  }
  narrowphase::force_simd_target(0);
}

Mesh scaled(const Mesh& mesh, double scale) {
  std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& v : vertices)
    v = scale * v;
  return mesh.deformed(vertices);
}

Eigen::Vector3d outermost(const PlacedMesh& placed, const Eigen::Vector3d& axis) {
  Eigen::Vector3d most = placed.pose * placed.mesh.vertices()[0];
  for (const Eigen::Vector3d& v : placed.mesh.vertices()) {
    const Eigen::Vector3d at = placed.pose * v;
    if (axis.dot(at) > axis.dot(most)) most = at;
  }
  return most;
}

class CastWalk : public testing::Test {
 protected:
  Mesh soup(std::size_t count) {
    return tests::random_soup({.count = count, .size = source_.uniform(0.05, 0.5)}, source_);
  }
  /// Somewhere beside A, on a way that may meet it.
  WalkQuestion question(std::size_t triangles = 40) {
    WalkQuestion q{{soup(triangles), tests::random_pose(0.5, source_)},
                   {soup(triangles), tests::random_pose(0.5, source_)},
                   source_.vector(-1, 1)};
    q.b.pose.translation() += -3 * q.displacement.normalized() + 0.5 * source_.vector(-1, 1);
    q.displacement = 6 * q.displacement.normalized();
    return q;
  }

  RandomSource source_{1401};
  std::vector<std::int64_t> targets_ = narrowphase::simd_targets();
};

TEST_F(CastWalk, FindsWhatEachPairAloneIsMetIn) {
  for (int n = 0; n < 60; ++n)
    expect_earliest(question(), targets_, n);
}

// B's outermost corner passes A's by next to nothing, touches it, or goes in,
// near the origin and far from it, where placing rounds.
TEST_F(CastWalk, SeesWhatGrazesInPassing) {
  int met = 0, passed = 0;
  for (int n = 0; n < 300; ++n) {
    WalkQuestion q = question();
    const Eigen::Vector3d far =
        n % 2 == 0 ? Eigen::Vector3d(0, 0, 0)
                   : Eigen::Vector3d(std::exp2(source_.uniform(0, 40)) * source_.vector(-1, 1));
    q.a.pose.translation() += far;
    q.b.pose.translation() += far;
    const Eigen::Vector3d across = q.displacement.unitOrthogonal();
    const Eigen::Vector3d from = outermost(q.b, -across), to = outermost(q.a, across);
    const double beside = std::exp2(source_.uniform(-56, -20)) * (n % 3 - 1);
    const Eigen::Vector3d way = q.displacement.normalized();
    q.b.pose.translation() += (to - from) - way.dot(to - from) * way + beside * across;
    q.b.pose.translation() -= 3 * way;
    expect_earliest(q, targets_, n);
    const bool is_met = cast(q.a, q.b, q.displacement).has_value();
    ++(is_met ? met : passed);
  }
  EXPECT_GT(met, 10);
  EXPECT_GT(passed, 50);
}

// One mesh is up to 2^40 times as large as the other, or the way as the meshes, and all may be far
// from the origin.
TEST_F(CastWalk, SizesAndWaysMayDiffer) {
  for (int n = 0; n < 90; ++n) {
    WalkQuestion q = question();
    const double scale = std::exp2(source_.uniform(-40, 40));
    if (n % 3 == 0) q.b.mesh = scaled(q.b.mesh, std::min(scale, 1 / scale));
    if (n % 3 == 1) {
      q.b.pose.translation() -= scale * q.displacement;
      q.displacement *= 2 * scale;
    }
    if (n % 3 == 2) {
      const Eigen::Vector3d far = scale * source_.vector(-1, 1);
      q.a.pose.translation() += far;
      q.b.pose.translation() += far;
    }
    expect_earliest(q, targets_, n);
  }
}

// So far away that no float holds it; along an axis the other coordinates are kept.
TEST_F(CastWalk, ComesFromAnywhere) {
  int met = 0;
  for (int n = 0; n < 12; ++n) {
    WalkQuestion q = question(12);
    const double far = std::exp2(source_.uniform(100, 200));
    const int axis = n % 3;
    q.displacement = 1.5 * far * Eigen::Vector3d::Unit(axis);
    q.b.pose.translation() = 0.5 * source_.vector(-1, 1);
    q.b.pose.translation()[axis] = -far;
    expect_earliest(q, targets_, n);
    met += cast(q.a, q.b, q.displacement).has_value();
  }
  EXPECT_GT(met, 4);
}

// One so large and one so small that their sizes have no quotient; either goes.
TEST_F(CastWalk, HugeMeetsTiny) {
  int met = 0;
  for (int n = 0; n < 24; ++n) {
    WalkQuestion q = question(12);
    q.a.mesh = scaled(q.a.mesh, 0x1p600);
    q.a.pose.translation() *= 0x1p600;
    q.b.mesh = scaled(q.b.mesh, 0x1p-600);
    q.displacement *= 0x1p600;
    const Triangle target = place(q.a.pose, q.a.mesh.triangle(1));
    q.b.pose.translation() =
        0.3 * target.a + 0.3 * target.b + 0.4 * target.c - 0.5 * q.displacement;
    if (n % 2 == 1) {
      std::swap(q.a, q.b);
      q.displacement = -q.displacement;
    }
    expect_earliest(q, targets_, n);
    met += cast(q.a, q.b, q.displacement).has_value();
  }
  EXPECT_GT(met, 16);
}

}  // namespace
}  // namespace graze
