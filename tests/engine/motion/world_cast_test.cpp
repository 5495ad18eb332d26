// To which bodies of a world a shape in rigid motion comes (law 14).

#include <graze/bvh/error.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

#include "tests/engine/body_world/users_ball.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;

Shape random_shape(RandomSource& source, int kind) {
  const double size = source.uniform(0.1, 0.6);
  switch (kind % 5) {
    case 0:
      return Sphere{{0, 0, 0}, size};
    case 1:
      return Box{{size, 0.5 * size, 0.02}};
    case 2:
      return Capsule{0.2 * size, size};
    case 3:
      return Cone{size, size};
    default:
      return tests::make_box({size, 0.3, 0.1});
  }
}

Pose random_pose(RandomSource& source, double reach) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd{source.uniform(-3, 3), source.vector(-1, 1).normalized()}
                      .toRotationMatrix();
  pose.translation() = source.vector(-reach, reach);
  return pose;
}

RigidMotion random_motion(RandomSource& source, int n) {
  const Pose start = random_pose(source, 3);
  return {start,
          {.centre = source.vector(-1, 1),
           .shift = start.translation() * -source.uniform(1, 2),
           .axis = source.vector(-1, 1),
           .angle = n % 3 == 0 ? 0 : source.uniform(-7, 7)}};
}

/// Each body asked alone, without any box.
TEST(Law14World, AllBodiesAreFoundThatOneByOneAreMet) {
  RandomSource source(501);
  int hits = 0;
  for (int n = 0; n < 100; ++n) {
    World world(WorldSettings{});
    std::map<BodyId, std::pair<Shape, Pose>> bodies;
    for (int i = 0; i < 24; ++i) {
      const Shape shape = random_shape(source, i);
      const Pose pose = random_pose(source, 2);
      bodies.emplace(world.add({shape, pose}), std::pair(shape, pose));
    }
    const Shape shape = random_shape(source, n);
    const RigidMotion motion = random_motion(source, n);
    const RigidContactSettings settings{.clearance = n % 4 == 0 ? 0.05 : 0};
    const std::vector<BodyCast> casts = world.cast_all({shape, motion}, settings);
    std::size_t met = 0;
    for (const auto& each : bodies) {
      const BodyId id = each.first;  // a lambda of clang 14 captures no binding
      const auto& body = each.second;
      const RigidContact alone =
          first_contact({shape, motion}, {body.first, RigidMotion(body.second)}, settings);
      const auto found = std::find_if(casts.begin(), casts.end(),
                                      [&](const BodyCast& cast) { return cast.id == id; });
      if (alone.status == RigidStatus::Free) {
        EXPECT_EQ(found, casts.end());
        continue;
      }
      ASSERT_NE(found, casts.end()) << n;
      EXPECT_EQ(found->contact, alone);
      ++met;
    }
    EXPECT_EQ(casts.size(), met);
    EXPECT_TRUE(std::is_sorted(casts.begin(), casts.end(), [](const auto& s, const auto& t) {
      return s.contact.low < t.contact.low;
    }));
    const std::optional<BodyCast> first = world.cast({shape, motion}, settings);
    EXPECT_EQ(first.has_value(), !casts.empty());
    if (first) {
      EXPECT_EQ(*first, casts.front());
    }
    hits += static_cast<int>(met);
  }
  EXPECT_GT(hits, 100);
}

TEST(Law14World, NothingTunnelsHoweverThinTheWall) {
  World world(WorldSettings{});
  const BodyId wall = world.add({Box{{1e-6, 10, 10}}, at(5, 0, 0)});
  const BodyId behind = world.add({tests::make_box({0.5, 0.5, 0.5}), at(20, 0, 0)});
  const Shape bullet = Sphere{{0, 0, 0}, 0.001};
  const RigidMotion shot(at(-100, 0, 0), {.shift = {1000, 0, 0}});
  const std::optional<BodyCast> first = world.cast({bullet, shot});
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->id, wall);
  EXPECT_EQ(first->contact.status, RigidStatus::Hit);
  EXPECT_LE(first->contact.low, (105 - 1e-6 - 0.001) / 1000);
  EXPECT_NEAR(first->contact.low, (105 - 1e-6 - 0.001) / 1000, 1e-8);
  const std::vector<BodyCast> all = world.cast_all({bullet, shot});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].id, behind);
  EXPECT_NEAR(all[1].contact.low, (119.5 - 0.001) / 1000, 1e-8);
}

/// Beside a body whose box it never meets, by less than the clearance and by more.
TEST(Law14World, AClearanceReachesBeyondBoxes) {
  World world(WorldSettings{});
  const BodyId beside = world.add({Box{{1, 1, 1}}, at(0, 2.03, 0)});
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const RigidMotion past(at(-5, 0, 0), {.shift = {10, 0, 0}});
  EXPECT_FALSE(world.cast({ball, past}).has_value());
  EXPECT_FALSE(world.cast({ball, past}, {.clearance = 0.02}).has_value());
  const std::optional<BodyCast> near = world.cast({ball, past}, {.clearance = 0.05});
  ASSERT_TRUE(near.has_value());
  EXPECT_EQ(near->id, beside);
  EXPECT_EQ(near->contact.status, RigidStatus::Hit);
  // Its centre comes within a radius and the clearance of the edge at x = -1, y = 1.03.
  EXPECT_NEAR(near->contact.low, (4 - std::sqrt(1.05 * 1.05 - 1.03 * 1.03)) / 10, 1e-6);
}

TEST(Law14World, FiltersMovesAndTurns) {
  World world(WorldSettings{});
  const BodyId floor = world.add({HalfSpace{{0, 0, 1}, 0}, Pose::Identity()},
                                 {.kind = BodyKind::Static, .filter = {.category = 2}});
  const BodyId post = world.add({Cylinder{0.1, 1}, at(3, 0, 1)});
  const Shape rod = Capsule{0.05, 0.5};
  // Rolling on the floor it touches from the start; without the floor the post is the first.
  const RigidMotion slide(at(0, 0, 0.5), {.shift = {6, 0, 0}});
  EXPECT_EQ(world.cast({rod, slide})->id, floor);
  EXPECT_EQ(world.cast({rod, slide})->contact.low, 0);
  const BodyQuerySettings bodies_alone{.filter = Filter{.mask = 1}};
  EXPECT_EQ(world.cast({rod, slide}, {}, bodies_alone)->id, post);
  // Around a centre 3 metres away, half a turn: it comes to the post after a quarter.
  const RigidMotion swing(at(0, 3, 1),
                          {.centre = {0, 0, 0}, .axis = {0, 0, -1}, .angle = std::numbers::pi});
  const std::optional<BodyCast> swung = world.cast({rod, swing}, {}, bodies_alone);
  ASSERT_TRUE(swung.has_value());
  EXPECT_NEAR(swung->contact.low, 0.5 - 2 * std::asin(0.15 / 6) / std::numbers::pi, 1e-6);
  // Moves count before an update.
  world.move(post, at(3, 0, 100));
  EXPECT_FALSE(world.cast({rod, swing}, {}, bodies_alone).has_value());
}

// A user's own shape throws where it is asked.
TEST(Law14World, OnlyThoseAreAskedThatItMayComeToFirst) {
  World world(WorldSettings{});
  world.add({std::make_shared<const tests::UsersBall>(0.5), at(8, 2, 0)});
  const Shape ball = Sphere{{0, 0, 0}, 0.5};
  // Beside the way, in the box of all of its places.
  const RigidMotion slant(at(0, 0, 0), {.shift = {10, 10, 0}});
  EXPECT_FALSE(world.cast({ball, slant}).has_value());
  EXPECT_TRUE(world.cast_all({ball, slant}).empty());
  // On the way, and behind something else.
  const RigidMotion along(at(0, 2, 0), {.shift = {10, 0, 0}});
  EXPECT_THROW(world.cast({ball, along}), UnsupportedPairError);
  const BodyId wall = world.add({Box{{0.1, 2, 2}}, at(4, 2, 0)});
  const auto met = world.cast({ball, along});
  ASSERT_TRUE(met.has_value());
  EXPECT_EQ(met->id, wall);
  EXPECT_NEAR(met->contact.low, 0.34, 1e-6);
  EXPECT_THROW(world.cast_all({ball, along}), UnsupportedPairError);
  // As near as the clearance, where boxes as they are do not meet.
  EXPECT_THROW(world.cast_all({ball, slant}, {.clearance = 4}), UnsupportedPairError);
}

TEST(Law14World, ABudgetEndsNoEarlierThanBoxesMeet) {
  World world(WorldSettings{});
  const BodyId far = world.add({Box{{1, 1, 1}}, at(6, 0, 0)});
  const BodyId near = world.add({Sphere{{0, 0, 0}, 0.5}, at(3, 0, 0)});
  const RigidMotion along(at(0, 0, 0), {.shift = {10, 0, 0}});
  const auto all = world.cast_all({Sphere{{0, 0, 0}, 0.5}, along}, {.budget = 0});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].id, near);
  EXPECT_EQ(all[1].id, far);
  for (const BodyCast& each : all) {
    EXPECT_TRUE(each.contact.is_out_of_budget);
    EXPECT_EQ(each.contact.status, RigidStatus::Close);
  }
  EXPECT_NEAR(all[0].contact.low, 0.2, 1e-6);
  EXPECT_NEAR(all[1].contact.low, 0.45, 1e-6);
  EXPECT_EQ(world.cast({Sphere{{0, 0, 0}, 0.5}, along}, {.budget = 0}), all[0]);
}

TEST(Law14World, BadInputIsRefused) {
  World world(WorldSettings{});
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  const RigidMotion motion(at(0, 0, 5), {.shift = {0, 0, -10}});
  const Shape ball = Sphere{{0, 0, 0}, 1};
  EXPECT_THROW(world.cast({ball, motion}, {.clearance = -1}), InputError);
  EXPECT_THROW(world.cast({ball, motion}, {.tolerance = HUGE_VAL}), InputError);
  EXPECT_FALSE(World(WorldSettings{}).cast({ball, motion}).has_value());
}

}  // namespace
}  // namespace graze
