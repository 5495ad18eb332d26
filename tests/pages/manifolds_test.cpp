// The programs of samples/manifolds.md, word for word, as one small solver of boxes that do not
// turn.

#include <graze/graze.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/shapes/pose_at.h"

namespace {

using graze::tests::at;

TEST(ManifoldPrograms, KeepABoxOnItsFloorUntilItSleeps) {
  constexpr double kStep = 1.0 / 150, kMass = 2;  // seconds, kilograms
  graze::World world;
  const graze::BodyId floor =
      world.add({graze::Box{{1, 1, 0.5}}, at(0, 0, -0.5)}, {.kind = graze::BodyKind::Static});
  const graze::BodyId box = world.add({graze::Box{{0.1, 0.1, 0.1}}, at(0, 0, 0.11)});
  Eigen::Vector3d place(0, 0, 0.11), velocity(0.3, 0, 0);

#include "manifolds_2.inc"
#include "manifolds_4.inc"
#include "manifolds_5.inc"
#include "manifolds_6.inc"

  double still_for = 0;
  bool has_touched = false;
  for (int step = 0; step < 450 && world.is_awake(box); ++step) {
#include "manifolds_3.inc"
    wake(update);
    velocity.z() -= 9.81 * kStep;
    for (int turn = 0; turn < 10; ++turn) {
      for (auto& [pair, rows] : kept) {
        for (Row& row : rows) {
          has_touched = true;
          // The floor has the lesser id: it is A.
          const double nearing = turn == 0 ? -velocity.dot(row.normal) : 0;
          const double apart = gap(row, world.pose(floor), at(place.x(), place.y(), place.z()));
          const double wanted = std::max(wanted_speed(apart, kStep), bounce(nearing, 0));
          velocity += solve(row, velocity, wanted, kMass / 4, 0.5) / kMass;
        }
      }
    }
    place += kStep * velocity;
    world.move(box, at(place.x(), place.y(), place.z()));
    still_for = velocity.norm() < 0.01 ? still_for + kStep : 0;
    rest({box}, still_for);
  }
  EXPECT_TRUE(has_touched);
  EXPECT_FALSE(world.is_awake(box));
  EXPECT_NEAR(place.z(), 0.1, 1e-3);
  EXPECT_GT(place.x(), 0.005);  // it slid 0.3^2 / (2 * 0.5 * 9.81) m on the floor
  EXPECT_LT(place.x(), 0.04);
  EXPECT_EQ(bounce(1, 0.5), 0.5);
  EXPECT_EQ(bounce(0.1, 0.5), 0);

  world.update();
#include "manifolds_1.inc"
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].find("region 0: 4 contacts, "), 0u);
}

TEST(ManifoldPrograms, SeeWhatIsNear) {
  graze::World world;
  world.add({graze::Box{{1, 1, 0.5}}, at(0, 0, -0.5)}, {.kind = graze::BodyKind::Static});
  const graze::Pose above = at(0, 0, 0.03);
  double least_gap = 1;
#include "manifolds_7.inc"
  EXPECT_NEAR(least_gap, 0.02, 1e-12);
  EXPECT_TRUE(world.contains(dart));
}

}  // namespace
