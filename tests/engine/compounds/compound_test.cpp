// Compounds as values: parts by numbers, what is refused, what they say without a world, and what
// many parts cost.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::at;

using Numbers = std::vector<std::uint32_t>;

const Shape kBall = Sphere{{0, 0, 0}, 0.5};

TEST(Compound, KnowsPartsByNumbersThatAreUsedAgain) {
  Compound compound;
  EXPECT_EQ(compound.add({kBall, at(0)}, {.user_data = 7, .material = 3}), 0u);
  EXPECT_EQ(compound.add({kBall, at(1)}), 1u);
  EXPECT_EQ(compound.add({kBall, at(2)}), 2u);
  compound.remove(1);
  EXPECT_EQ(compound.parts(), (Numbers{0, 2}));
  EXPECT_FALSE(compound.contains(1));
  EXPECT_EQ(compound.size(), 2u);
  EXPECT_EQ(compound.add({Box{{1, 1, 1}}, at(3)}), 1u);
  EXPECT_EQ(compound.part(1).shape.kind(), ShapeKind::Box);
  compound.replace(0, {Box{{2, 2, 2}}, at(9)});
  EXPECT_EQ(compound.part(0).pose.translation().x(), 9);
  EXPECT_EQ(compound.settings(0).user_data, 7u) << "settings stay";
  EXPECT_EQ(compound.settings(0).material, 3u);
  compound.set_settings(0, {.material = 4});
  EXPECT_EQ(compound.settings(0).material, 4u);
}

TEST(Compound, OverlapsWithinOneBodyAreNobodysContact) {
  World world;
  Compound heap;
  for (int i = 0; i < 40; ++i)
    heap.add({kBall, at(0.1 * i)});
  heap.add({tests::make_box({1, 1, 1}), at(0)});
  VoxelMap full(VoxelGrid{{0, 0, 9}, 0.25, {8, 8, 8}});
  full.add_block({0, 0, 0}, {7, 7, 7});
  const BodyId body = world.add({share(heap), at(0)}), map = world.add({share(full), at(0)});
  const WorldUpdate update = world.update();
  EXPECT_TRUE(update.begun.empty() && update.contacts.empty() && world.contacts().empty());
  EXPECT_TRUE(world.pairs(body).empty() && world.pairs(map).empty());
  EXPECT_GT(world.find_closest_pair()->distance.distance, 7);
}

TEST(Compound, WhatIsSharedStaysAsItWas) {
  Compound compound;
  compound.add({kBall, at(0)});
  const auto shared = share(compound);
  compound.replace(0, {kBall, at(50)});
  EXPECT_LT(shared->bounds(at(0)).max.x(), 1);
  ASSERT_NE(compound_of(*shared), nullptr);
  EXPECT_EQ(compound_of(*shared)->part(0).pose.translation().x(), 0);
  EXPECT_EQ(compound_of(*share(kBall)), nullptr);
  EXPECT_EQ(shared->shape(), nullptr);
}

template <typename Error, typename Call>
std::string what_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no such error";
}

TEST(Compound, RefusesWhatItCannotHold) {
  Compound compound;
  EXPECT_NE(what_of<InputError>([&] { share(compound); }).find("without parts"), std::string::npos);
  EXPECT_NE(what_of<InputError>([&] {
              compound.add({HalfSpace{{0, 0, 1}}, at(0)});
            }).find("half-space"),
            std::string::npos);
  EXPECT_THROW(compound.add({kBall, at(std::numeric_limits<double>::quiet_NaN())}), PoseError);
  EXPECT_THROW(compound.add({kBall, at(1e101)}), PoseError);
  Pose bent = at(0);
  bent.linear()(0, 1) = 1e-3;
  EXPECT_THROW(compound.add({kBall, bent}), PoseError);
  EXPECT_EQ(compound.size(), 0u);
  compound.add({kBall, at(0)});
  EXPECT_THROW(compound.replace(0, {kBall, bent}), PoseError);
  for (const auto& call : std::vector<std::function<void()>>{
           [&] { compound.remove(1); }, [&] { compound.part(1); }, [&] { compound.settings(1); },
           [&] { compound.set_settings(1, {}); },
           [&] {
             compound.replace(1, {kBall, at(0)});
           }}) {
    try {
      call();
      ADD_FAILURE();
    } catch (const StaleIdError& error) {
      EXPECT_EQ(error.place().element, "part");
      EXPECT_EQ(error.place().index, 1u);
    }
  }
  // Far away where two poses add up, and bent where two deviations do.
  compound.replace(0, {kBall, at(0.9e100)});
  const auto far = share(compound);
  EXPECT_THROW(far->bounds(at(0.9e100)), PoseError);
  Pose slightly = at(0);
  slightly.linear()(0, 1) = 0.9e-6;
  compound.replace(0, {kBall, slightly});
  EXPECT_NO_THROW(share(compound)->bounds(at(0)));
  EXPECT_THROW(share(compound)->bounds(slightly), PoseError);
  World world;
  const BodyId id = world.add({share(compound), at(0)});
  EXPECT_THROW(world.move(id, slightly), PoseError);
  EXPECT_THROW(world.add({share(compound), at(0)}, {.sides = MeshSides::solid()}), InputError);
}

/// A part without a pose of its own is placed as its body is, to the bit.
TEST(Compound, PlacesItsPartsByTheLaw) {
  RandomSource source(1);
  for (int i = 0; i < 100; ++i) {
    const Pose body = tests::random_pose(source, 10), part = tests::random_pose(source, 10);
    EXPECT_TRUE(are_equal(placed_part(body, at(0)), body));
    EXPECT_TRUE(are_equal(placed_part(at(0), part), part));
    const Pose placed = placed_part(body, part);
    EXPECT_LT((placed.matrix() - (body * part).matrix()).norm(), 1e-13);
  }
}

TEST(Compound, AnswersWithoutAWorld) {
  Compound compound;
  compound.add({kBall, at(-2)}), compound.add({kBall, at(2)});
  const auto shared = share(compound), rod = share(Box{{3, 0.1, 0.1}});
  EXPECT_TRUE(shared->touches(at(0), *rod, at(0)));
  EXPECT_TRUE(rod->touches(at(0), *shared, at(0)));
  EXPECT_FALSE(shared->touches(at(0), *rod, at(0, 1)));
  const Manifold contacts = shared->contacts(at(0), *rod, at(0, 0.5));
  EXPECT_EQ(contacts.region_count(), 2u);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NE(contacts[i].feature, contacts[j].feature);
  const Manifold mirrored = rod->contacts(at(0, 0.5), *shared, at(0));
  ASSERT_EQ(mirrored.size(), contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    EXPECT_EQ(mirrored[i].normal, -contacts[i].normal);
  EXPECT_EQ(shared->contacts_within(at(0), *rod, at(0, 0.7), 0.2).region_count(), 2u);
  EXPECT_EQ(rod->contacts_within(at(0, 0.7), *shared, at(0), 0.2).region_count(), 2u);
  EXPECT_TRUE(rod->meet(at(0, 0.5), *shared, at(0)).has_value());
  EXPECT_NEAR(shared->cast_ray(at(0), {{9, 0, 0}, {-1, 0, 0}})->distance, 6.5, 1e-12);
  EXPECT_FALSE(shared->cast_ray(at(0), {{0, 9, 0}, {0, -1, 0}}));
  const RigidMotion rest(at(0)), down(at(0, 5), {.shift = {0, -5, 0}});
  const RigidContact met = shared->first_contact(rest, *rod, down, {});
  EXPECT_EQ(met.status, RigidStatus::Hit);
  EXPECT_NEAR(met.low, 0.88, 1e-3);
  EXPECT_EQ(rod->first_contact(down, *shared, rest, {}), met);
  const RigidMotion up(at(0, 5), {.shift = {0, 5, 0}});
  EXPECT_EQ(shared->first_contact(rest, *rod, up, {}).status, RigidStatus::Free);
  EXPECT_GE(shared->bounding_radius(), 2.5);
}

/// Work that a pair takes follows what is near, not how many parts there are.
TEST(Compound, ManyPartsAreCheap) {
  Compound level;
  for (int x = 0; x < 100; ++x)
    for (int y = 0; y < 100; ++y)
      level.add({Box{{0.5, 0.5, 0.5}}, at(x, y, -0.5)});
  World world({.contacts = false});
  const BodyId floor = world.add({share(level), at(0)}, {.kind = BodyKind::Kinematic});
  const BodyId ball = world.add({Capsule{0.5, 0.1}, at(50.25, 50.25, 0.55)});
  world.update();
  EXPECT_EQ(world.pairs().size(), 1u) << "what overlaps within a body is nobody's contact";
  EXPECT_EQ(world.touching(ball), std::vector{floor});
  for (int i = 1; i < 10; ++i) {
    world.move(floor, at(0.01 * i, 0, 0));
    const Work work = world.update().work.shapes;
    EXPECT_GE(work.convex_tests, 1u);
    EXPECT_LE(work.convex_tests, 9u);
  }
}

}  // namespace
}  // namespace graze
