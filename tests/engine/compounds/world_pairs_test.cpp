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
#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

/// A part, or a body that has none, in the frame of the world that is asked.
struct Piece {
  BodyId body;
  std::uint32_t part;
  Shape shape;
  Pose pose;
  Filter filter;
  Role role;
  BodyKind kind;
};

std::vector<Piece> pieces_of(const World& world, const Pose& in) {
  std::vector<Piece> pieces;
  for (const BodyId id : world.bodies()) {
    const Pose pose = placed_part(in, world.pose(id));
    const auto add = [&](std::uint32_t part, const Shape& shape, const Pose& of_part,
                         const Filter& filter) {
      pieces.push_back({id, part, shape, of_part, filter, world.role(id), world.kind(id)});
    };
    if (const Compound* compound = compound_of(world.shape(id))) {
      for (const std::uint32_t part : compound->parts()) {
        const PlacedShape& placed = compound->part(part);
        add(part, placed.shape, placed_part(pose, placed.pose),
            compound->settings(part).filter.value_or(world.filter(id)));
      }
    } else {
      add(0, *world.shape(id).shape(), pose, world.filter(id));
    }
  }
  return pieces;
}

bool are_asked_for(const World& world_a, const Piece& a, const World& world_b, const Piece& b,
                   const WorldPairSettings& settings) {
  if (settings.role && (a.role != *settings.role || b.role != *settings.role)) return false;
  if (!settings.has_filters) return true;
  return lets_pass(world_a.filter(a.body), world_b.filter(b.body)) && lets_pass(a.filter, b.filter);
}

bool is_nearer(const BodyPairDistance& s, const BodyPairDistance& t) {
  const auto key = [](const BodyPairDistance& each) {
    return std::tuple(each.distance.distance, each.a, each.b, each.part_a, each.part_b);
  };
  return key(s) < key(t);
}

/// What all pairs of pieces say.
struct Truth {
  std::vector<WorldBodyPair> touching;
  std::vector<BodyPairDistance> within;
  std::optional<BodyPairDistance> closest;
};

Truth truth_of(const World& a, const World& b, const Pose& pose, double clearance,
               const WorldPairSettings& settings) {
  Truth truth;
  const std::vector<Piece> pieces_b = pieces_of(b, pose);
  std::vector<BodyPairDistance> all;
  for (const Piece& s : pieces_of(a, Pose::Identity())) {
    for (const Piece& t : pieces_b) {
      if (!are_asked_for(a, s, b, t, settings)) continue;
      if (intersects({s.shape, s.pose}, {t.shape, t.pose}))
        truth.touching.push_back({s.body, t.body});
      all.push_back(
          {s.body, t.body, distance({s.shape, s.pose}, {t.shape, t.pose}), s.part, t.part});
    }
  }
  std::sort(truth.touching.begin(), truth.touching.end());
  truth.touching.erase(std::unique(truth.touching.begin(), truth.touching.end()),
                       truth.touching.end());
  std::sort(all.begin(), all.end(), is_nearer);
  if (!all.empty()) truth.closest = all[0];
  for (const BodyPairDistance& each : all) {
    const bool is_known = std::any_of(
        truth.within.begin(), truth.within.end(),
        [&](const BodyPairDistance& other) { return other.a == each.a && other.b == each.b; });
    if (!is_known && each.distance.distance <= clearance) truth.within.push_back(each);
  }
  std::sort(truth.within.begin(), truth.within.end(),
            [](const BodyPairDistance& s, const BodyPairDistance& t) {
              return std::tie(s.a, s.b) < std::tie(t.a, t.b);
            });
  return truth;
}

Shape any_shape(RandomSource& source) {
  return tests::random_small_shape(source, static_cast<int>(source.integer(0, 5)));
}

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

void expect_equal(const std::vector<BodyPairDistance>& found,
                  const std::vector<BodyPairDistance>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const BodyPairDistance &s = found[i], &t = wanted[i];
    EXPECT_TRUE(s == t) << s.a.index << "/" << s.part_a << " " << s.b.index << "/" << s.part_b
                        << " at " << s.distance.distance << ", not " << t.a.index << "/" << t.part_a
                        << " " << t.b.index << "/" << t.part_b << " at " << t.distance.distance;
  }
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
