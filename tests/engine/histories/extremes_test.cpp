// What is rare: many bodies in one point, sizes and places that are far apart, leaps.

#include <graze/engine/work.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::at;

/// All pairs, then one leaves and comes back.
void expect_all_pairs(std::uint32_t count) {
  BroadPhase boxes;
  const Aabb point{{1, 2, 3}, {1, 2, 3}};
  std::vector<BoxId> ids;
  for (std::uint32_t i = 0; i < count; ++i)
    ids.push_back(boxes.add(point));
  boxes.update();
  EXPECT_EQ(boxes.pairs().size(), std::size_t{count} * (count - 1) / 2);
  EXPECT_EQ(boxes.begun().size(), boxes.pairs().size());
  boxes.move(ids[5], {{1, 2, std::nextafter(3, 4)}, {1, 2, 4}});
  boxes.update();
  EXPECT_EQ(boxes.ended().size(), count - 1);
  EXPECT_EQ(boxes.pairs().size(), std::size_t{count - 1} * (count - 2) / 2);
  boxes.move(ids[5], {{1, 2, 3}, {1, 2, 4}});
  boxes.update();
  EXPECT_EQ(boxes.begun().size(), count - 1);
  EXPECT_TRUE(boxes.ended().empty());
}

TEST(OnePoint, OfAThousandBoxesAllOverlap) {
  expect_all_pairs(1000);
}

TEST(OnePointSlow, OfTenThousandBoxesAllOverlap) {
  expect_all_pairs(10000);
}

TEST(OnePoint, OfThreeHundredBodiesAllTouch) {
  World world;
  const auto ball = share(Sphere{{0, 0, 0}, 1e-6});
  std::vector<BodyId> ids;
  for (int i = 0; i < 300; ++i)
    ids.push_back(world.add({ball, at(1, 2, 3)}));
  const WorldUpdate all = world.update();
  EXPECT_EQ(all.begun.size(), 300u * 299 / 2);
  EXPECT_EQ(all.contacts.size(), all.begun.size());
  world.move(ids[7], at(1, 2, 3.1));
  EXPECT_EQ(world.update().ended.size(), 299u);
  EXPECT_EQ(world.find_touching({Sphere{{0, 0, 0}, 1}, at(1, 2, 3)}).size(), 300u);
  EXPECT_EQ(world.cast_ray({{0, 2, 3}, {1, 0, 0}})->id, ids[0]);
}

/// Whose difference is flat: they are parted at right angles to both, by their radii alone.
TEST(OnePoint, OfTwoCapsulesHasAKnownWayOut) {
  const auto turned = [](double angle, int axis) {
    return Pose(Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)));
  };
  const Pose there = turned(0.7, 0) * at(1, 2, 3) * turned(0.4, 2);
  for (const double angle : {0.0, 1e-12, 1e-6, 0.3, 1.5}) {
    // Rolled about its own axis, so that none of its axes is the way out.
    const Pose other = there * turned(angle, 1) * turned(1.1, 2);
    Work work;
    const Manifold found =
        find_contacts({Capsule{0.25, 2}, there * turned(-0.8, 2)}, {Capsule{0.5, 1}, other}, &work);
    EXPECT_EQ(work.penetration_failures, 0u) << angle;
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found[0].depth, 0.75, 1e-6) << angle;
    EXPECT_NEAR(found[0].normal.dot(other.linear().col(2)), 0, 1e-6) << angle;
  }
}

/// Fifty million pairs of boxes, of which a filter lets through those of ten bodies.
TEST(OnePointSlow, OfTenThousandBodiesFewMayMeet) {
  World world({.threads = 2, .contacts = false});
  const auto ball = share(Sphere{{0, 0, 0}, 1});
  std::vector<BodyId> ids;
  for (int i = 0; i < 10000; ++i) {
    const BodyKind motion = i % 1000 == 0 ? BodyKind::Dynamic : BodyKind::Static;
    ids.push_back(world.add({ball, at(1, 2, 3)}, {.kind = motion}));
  }
  const WorldUpdate all = world.update();
  EXPECT_EQ(all.begun.size(), 10u * 9990 + 45);
  EXPECT_EQ(all.work.pairs_filtered + all.begun.size(), 10000u * 9999 / 2);
  EXPECT_EQ(all.work.shape_tests, all.begun.size());
  world.move(ids[1000], at(50, 2, 3));
  EXPECT_EQ(world.update().ended.size(), 9999u);
}

TEST(Sizes, AGrainOnAContinentIsExactToTheGrain) {
  for (const Shape& ground : {Shape(Box{{1e6, 1e6, 1e6}}), Shape(Sphere{{0, 0, 0}, 1e6})}) {
    World world;
    world.add({ground, at(0, 0, -1e6)}, {.kind = BodyKind::Static});
    const BodyId grain = world.add({Sphere{{0, 0, 0}, 1e-6}, at(0, 0, 3e-6)});
    EXPECT_TRUE(world.update().begun.empty());
    world.move(grain, at(0, 0, 0.99e-6));
    const WorldUpdate down = world.update();
    ASSERT_EQ(down.begun.size(), 1u);
    ASSERT_EQ(down.contacts.size(), 1u);
    EXPECT_NEAR(down.contacts[0].manifold[0].depth, 0.01e-6, 1e-9);
    world.move(grain, at(0, 0, 1.01e-6));
    EXPECT_EQ(world.update().ended.size(), 1u);
  }
}

/// Where a double is 2^-29 wide, 1.9e-9.
TEST(FarAway, TouchIsToTheUlp) {
  const double step = 0x1p-29;
  for (const Shape& shape : {Shape(Sphere{{0, 0, 0}, 0.5}), Shape(Box{{0.5, 0.5, 0.5}})}) {
    World world;
    world.add({shape, at(1e7, 1e7, -1e7)});
    const BodyId other = world.add({shape, at(1e7 + 1, 1e7, -1e7)});
    EXPECT_EQ(world.update().begun.size(), 1u);
    world.move(other, at(1e7 + 1 + step, 1e7, -1e7));
    EXPECT_EQ(world.update().ended.size(), 1u);
    world.move(other, at(1e7 + 1 - step, 1e7, -1e7));
    EXPECT_EQ(world.update().begun.size(), 1u);
  }
}

/// Leaps of 1e9 and of 1e99, in every step, of pairs that were known to be apart.
TEST(Leaps, AreSeenAtOnce) {
  World world;
  const BodyId drum = world.add({Cylinder{1, 1}, at(0, 0, 0)});
  const BodyId cone = world.add({Cone{0.5, 0.5}, at(1.3, 1.3, 0)});
  std::uint64_t skipped = 0;
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < 5; ++k) {
      world.move(cone, at(1.3, 1.3, 1e-4 * k));
      const WorldUpdate near = world.update();
      EXPECT_TRUE(near.begun.empty());
      EXPECT_EQ(near.ended.size(), k == 0 && i != 0 ? 1u : 0u);
      skipped += near.work.pairs_apart;
    }
    const double far = i % 2 == 0 ? 1e9 : 1e99;
    world.move(cone, at(far, 0, 0));
    EXPECT_TRUE(world.update().begun.empty());
    world.move(drum, at(far, 0, 0));
    EXPECT_EQ(world.update().begun.size(), 1u);
    EXPECT_EQ(world.find_closest({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)})->id, drum);
    world.move(std::vector<BodyId>{drum, cone}, std::vector<Pose>{at(0, 0, 0), at(0, 0, 0)});
    EXPECT_TRUE(world.update().begun.empty());
  }
  EXPECT_GT(skipped, 0u);
}

/// A body in two places at once: the last counts, and nothing lies between them.
TEST(Leaps, OnlyTheLastOfAStepCounts) {
  World world;
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  const BodyId ball = world.add({Sphere{{0, 0, 0}, 1}, at(-5, 0, 0)});
  world.update();
  world.move(ball, at(0, 0, 0));
  world.move(ball, at(5, 0, 0));
  const WorldUpdate update = world.update();
  EXPECT_TRUE(update.begun.empty());
  EXPECT_TRUE(update.moved.empty());
}

/// A mesh may be a point, and a point that is asked about has no width to grow from.
TEST(FindClosest, GrowsFromNothing) {
  const Eigen::Vector3d origin(0, 0, 0);
  const Mesh point(std::vector<Eigen::Vector3d>{origin, origin, origin},
                   std::vector<TriangleIndices>{{0, 1, 2}});
  World world;
  world.add({Sphere{{0, 0, 0}, 1}, at(4, 0, 0)});
  const BodyId near = world.add({point, at(0, 2, 0)});
  EXPECT_EQ(world.find_closest({point, at(0, 0, 0)})->id, near);
  EXPECT_EQ(world.find_closest({point, at(0, 0, 0)})->distance.distance, 2);
}

}  // namespace
}  // namespace graze
