// Law 15 where bodies wrap around each other: teeth and threads are left along their flanks.

#include <gtest/gtest.h>

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

Mesh bundled(const char* name) {
  return load_mesh(std::string(GRAZE_DATA_DIR) + "/meshes/" + name);
}

Pose moved(const Pose& pose, const Vector3d& way) {
  Pose result = pose;
  result.translation() += way;
  return result;
}

/// The largest of the shifts along a direction, from a pose that is free to one that is not, at
/// which the two are still free, to a nanometre.
double last_free(const Mesh& a, const Mesh& b, const Pose& pose, const Vector3d& direction,
                 double blocked) {
  double free = 0;
  while (blocked - free > 1e-9) {
    const double middle = (free + blocked) / 2;
    const Pose tried = moved(pose, middle * direction);
    (intersects({a, Pose::Identity()}, {b, tried}) ? blocked : free) = middle;
  }
  return free;
}

/// The same thickness, with their caps in one plane: nothing leads out along the axle.
TEST(WayOut, Law15TeethAreLeftAlongTheirFlanks) {
  const Mesh gear = bundled("gear.ply"), pinion = bundled("pinion.off");
  constexpr double kTeeth = 19, kAxles = 0.05;
  int touching = 0;
  for (int n = 0; n < 60; ++n) {
    Pose of_gear = Pose::Identity(), of_pinion = tests::at(kAxles, 0, 0);
    const double turn = 2 * std::numbers::pi * n / 60 / 31;
    of_gear.linear() = AngleAxisd(turn, Vector3d::UnitZ()).toRotationMatrix();
    const double meshed = std::numbers::pi * (1 + 1 / kTeeth) - turn * 31 / kTeeth;
    // Turned on until the flanks meet, and a little further.
    double free = 0, met = std::numbers::pi / kTeeth;
    const auto turned = [&](double by) {
      Pose pose = of_pinion;
      pose.linear() = AngleAxisd(meshed + by, Vector3d::UnitZ()).toRotationMatrix();
      return pose;
    };
    while (met - free > 1e-9) {
      const double middle = (free + met) / 2;
      (intersects({gear, of_gear}, {pinion, turned(middle)}) ? met : free) = middle;
    }
    const double radius = kAxles * kTeeth / (kTeeth + 31);
    for (const double deep : {1e-6, 1e-5, 1e-4}) {
      const Manifold found =
          find_contacts({Shape(gear), of_gear}, {Shape(pinion), turned(met + deep / radius)});
      ASSERT_FALSE(found.empty()) << n << " " << deep;
      for (const ShapeContact& contact : found) {
        ++touching;
        EXPECT_LT(std::abs(contact.normal.z()), 1e-6) << n << " " << deep;
        EXPECT_LT(contact.depth, 1.3 * deep) << n << " " << deep;
      }
      // Flanks lean by some 20 degrees to the way they move.
      EXPECT_GT(found[0].depth, 0.7 * deep) << n << " " << deep;
    }
  }
  EXPECT_GT(touching, 180);
}

/// A nut that hangs on its bolt, and is let down into it by a little more. What it rests on are the
/// flanks, all around: each contact leads along one, none across the bolt.
TEST(WayOut, Law15ThreadsAreLeftAlongTheirFlanks) {
  const Mesh bolt = bundled("bolt.obj"), nut = bundled("nut.stl");
  constexpr double kPitch = 0.00125, kFlank = 0.866;  // flanks lean by 30 degrees
  const Vector3d down = -Vector3d::UnitZ();
  for (int n = 0; n < 12; ++n) {
    const double turn = 0.5 * n;
    Pose pose = tests::at(0, 0, 8 * kPitch + kPitch * turn / (2 * std::numbers::pi));
    pose.linear() = AngleAxisd(turn, Vector3d::UnitZ()).toRotationMatrix();
    ASSERT_FALSE(intersects({bolt, Pose::Identity()}, {nut, pose})) << n;
    const double play = last_free(bolt, nut, pose, down, kPitch / 4);
    for (const double deep : {2e-6, 1e-5, 4e-5}) {
      const Pose sunk = moved(pose, (play + deep) * down);
      const Manifold found = find_contacts({Shape(bolt), Pose::Identity()}, {Shape(nut), sunk});
      ASSERT_FALSE(found.empty()) << n << " " << deep;
      double up = 0;
      for (const ShapeContact& contact : found) {
        // The flank leans more where the thread runs out.
        EXPECT_GT(contact.normal.z(), 0.7) << n << " " << deep;
        EXPECT_LT(contact.normal.z(), kFlank + 0.01) << n << " " << deep;
        // Flanks are not quite parallel: at the rim of one the other is somewhat deeper.
        EXPECT_LT(contact.depth, 1.05 * deep) << n << " " << deep;
        up = std::max(up, contact.depth / contact.normal.z());
      }
      EXPECT_GT(up, 0.9 * deep) << n << " " << deep;
      EXPECT_FALSE(intersects({bolt, Pose::Identity()},
                              {nut, moved(sunk, 1.01 * deep * Vector3d::UnitZ())}));
    }
  }
}

}  // namespace
}  // namespace graze
