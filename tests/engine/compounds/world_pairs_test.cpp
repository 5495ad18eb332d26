// Pairs of bodies of two worlds, and of one, beside every pair of parts asked by itself.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "tests/engine/body_world/users_ball.h"
#include "tests/engine/compounds/pieces.h"
#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::any_shape;
using tests::are_asked_for;
using tests::expect_equal;
using tests::is_nearer;
using tests::Piece;
using tests::pieces_of;
using tests::Truth;
using tests::truth_of;

/// Bodies and compounds, sensors among them, with filters; a few indices have been used before.
void fill(World& world, int bodies, double spread, RandomSource& source) {
  const auto filter = [&] {
    return Filter{.category = static_cast<std::uint32_t>(source.integer(1, 3)),
                  .mask = static_cast<std::uint32_t>(source.integer(1, 3))};
  };
  std::vector<BodyId> gone;
  for (int i = 0; i < bodies; ++i) {
    BodySettings settings{.kind = i % 4 == 0 ? BodyKind::Static : BodyKind::Dynamic,
                          .filter = filter(),
                          .role = i % 5 == 0 ? Role::Sensor : Role::Solid,
                          .margin = i % 3 == 0 ? 0.5 : 0};
    const Pose pose = tests::random_pose(source, spread);
    if (i % 3 == 1) {
      Compound compound =
          tests::random_compound(source, static_cast<std::uint32_t>(source.integer(1, 24)), 0.5);
      for (const std::uint32_t part : compound.parts()) {
        if (part % 3 == 1) compound.set_settings(part, {.filter = filter()});
      }
      world.add({share(compound), pose}, settings);
    } else {
      const BodyId id = world.add({any_shape(source), pose}, settings);
      if (i % 7 == 0) gone.push_back(id);
    }
  }
  for (const BodyId id : gone)
    world.remove(id);
  world.add({any_shape(source), tests::random_pose(source, spread)});
}

TEST(WorldPairs, AreThoseOfAllPiecesAskedAlone) {
  RandomSource source(77);
  std::size_t touching = 0, near = 0, apart = 0;
  for (int round = 0; round < 80; ++round) {
    const double spread = source.uniform(1, 6);
    World cell, robot;
    fill(cell, 14, spread, source);
    fill(robot, 9, spread / 2, source);
    if (round % 2 == 0) cell.update();
    const Pose pose = tests::random_pose(source, round % 3 == 0 ? 3 * spread : 1);
    const WorldPairSettings settings{
        .has_filters = round % 4 != 1,
        .role = round % 5 == 2 ? std::optional(Role::Solid) : std::nullopt};
    const double clearance = round % 6 == 0 ? 0 : source.uniform(0, 1);
    const Truth truth = truth_of(cell, robot, pose, clearance, settings);
    EXPECT_EQ(cell.find_touching({robot, pose}, settings), truth.touching);
    expect_equal(cell.find_within({robot, pose}, clearance, settings), truth.within);
    EXPECT_EQ(cell.find_closest({robot, pose}, settings), truth.closest);
    touching += truth.touching.size();
    near += truth.within.size();
    apart += truth.closest && truth.closest->distance.distance > 0;
  }
  EXPECT_GT(touching, 50u);
  EXPECT_GT(near, 100u);
  EXPECT_GT(apart, 5u);
}

/// Equal distances: the first pair, and of that the first parts.
TEST(WorldPairs, TheFirstOfEqualsIsTheClosest) {
  Compound three;
  for (const int x : {2, 0, -2})
    three.add({Box{{0.5, 0.5, 0.5}}, tests::at(x)});
  World below, above;
  for (const int x : {8, -8, 0})
    below.add({share(three), tests::at(x)});
  for (const int x : {-8, 8, 0})
    above.add({share(three), tests::at(x)});
  const auto closest = below.find_closest({above, tests::at(0, 0, 2)});
  ASSERT_TRUE(closest);
  EXPECT_EQ(closest->distance.distance, 1);
  EXPECT_EQ(closest->a.index, 0u);
  EXPECT_EQ(closest->b.index, 1u);
  EXPECT_EQ(closest->part_a, 0u);
  EXPECT_EQ(closest->part_b, 0u);
  EXPECT_EQ(below.find_within({above, tests::at(0, 0, 2)}, 1).size(), 3u);
  EXPECT_TRUE(below.find_within({above, tests::at(0, 0, 2)}, 0.999).empty());
  // Touching, too.
  const auto touching = below.find_closest({above, tests::at(0, 0, 1)});
  ASSERT_TRUE(touching);
  EXPECT_EQ(touching->distance.distance, 0);
  EXPECT_EQ(std::tuple(touching->a.index, touching->b.index, touching->part_a, touching->part_b),
            std::tuple(0u, 1u, 0u, 0u));
  EXPECT_EQ(below.find_touching({above, tests::at(0, 0, 1)}).size(), 3u);
}

TEST(WorldPairs, ClosestOfOneWorldIsThatOfAllPairsThatMayMeet) {
  RandomSource source(78);
  std::size_t apart = 0;
  for (int round = 0; round < 24; ++round) {
    World world;
    fill(world, 14, source.uniform(4, 20), source);
    const std::vector<BodyId> ids = world.bodies();
    world.exclude(ids[0], ids[2]);
    if (round % 2 == 0)
      world.set_pair_filter([](BodyId a, BodyId b) { return (a.index + b.index) % 3 != 0; });
    const WorldPairSettings settings{
        .has_filters = round % 4 != 1,
        .role = round % 5 == 2 ? std::optional(Role::Solid) : std::nullopt};
    std::optional<BodyPairDistance> best;
    const std::vector<Piece> pieces = pieces_of(world, Pose::Identity());
    for (const Piece& s : pieces) {
      for (const Piece& t : pieces) {
        if (s.body.index >= t.body.index || !are_asked_for(world, s, world, t, settings)) continue;
        if (settings.has_filters) {
          const bool is_kept_apart = (s.body == ids[0] && t.body == ids[2]) ||
                                     (round % 2 == 0 && (s.body.index + t.body.index) % 3 == 0);
          const auto moves = [](const Piece& p) { return p.kind == BodyKind::Dynamic; };
          const bool is_sensed = s.role != t.role && (s.role == Role::Sensor ? moves(t) : moves(s));
          const bool is_solid_pair = s.role == Role::Solid && t.role == Role::Solid;
          if (is_kept_apart || !(is_sensed || (is_solid_pair && (moves(s) || moves(t))))) continue;
        }
        const BodyPairDistance found{s.body, t.body, distance({s.shape, s.pose}, {t.shape, t.pose}),
                                     s.part, t.part};
        if (!best || is_nearer(found, *best)) best = found;
      }
    }
    EXPECT_EQ(world.find_closest_pair(settings), best) << round;
    apart += best && best->distance.distance > 0;
  }
  EXPECT_GT(apart, 5u);
}

TEST(WorldPairs, FindsNothingWhereNothingIsAskedFor) {
  World empty, one;
  one.add({Sphere{{0, 0, 0}, 1}});
  EXPECT_TRUE(one.find_touching({empty}).empty());
  EXPECT_FALSE(one.find_closest({empty}).has_value());
  EXPECT_FALSE(empty.find_closest({one}).has_value());
  EXPECT_FALSE(empty.find_closest_pair().has_value());
  EXPECT_FALSE(one.find_closest_pair().has_value());
  EXPECT_FALSE(one.find_closest({one}, {.role = Role::Sensor}).has_value());
  EXPECT_EQ(one.find_closest({one, tests::at(9)})->distance.distance, 7);
}

TEST(WorldPairs, WhatIsBadIsRefused) {
  World cell, robot;
  cell.add({Sphere{{0, 0, 0}, 1}});
  robot.add({Box{{1, 1, 1}}});
  Pose twice = Pose::Identity();
  twice.linear() *= 2;
  EXPECT_THROW(cell.find_touching({robot, twice}), PoseError);
  EXPECT_THROW(cell.find_within({robot, twice}, 1), PoseError);
  EXPECT_THROW(cell.find_closest({robot, twice}), PoseError);
  EXPECT_THROW(cell.find_touching({robot, tests::at(1e200)}), PoseError);
  EXPECT_THROW(cell.find_within({robot}, -1), InputError);
  EXPECT_THROW(cell.find_within({robot}, std::numeric_limits<double>::quiet_NaN()), InputError);
  robot.add({std::make_shared<tests::UsersBall>(1), tests::at(9)});
  EXPECT_EQ(cell.find_touching({robot, tests::at(-9)}).size(), 1u) << "it can say yes or no";
  EXPECT_THROW(cell.find_within({robot, tests::at(-9)}, 1), UnsupportedPairError);
  EXPECT_THROW(cell.find_closest({robot, tests::at(-8)}), UnsupportedPairError);
  EXPECT_THROW(robot.find_closest_pair(), UnsupportedPairError);
}

}  // namespace
}  // namespace graze
