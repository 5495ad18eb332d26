// What compounds meet is what their parts meet as bodies of their own, bit for bit.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "tests/engine/body_world/users_ball.h"
#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::at;
using tests::Twins;

/// A level of many parts, compounds and single shapes over it.
void fill(Twins& twins, RandomSource& source, double reach, const BodySettings& settings = {}) {
  twins.add(tests::random_compound(source, 60, reach), at(0.1, 0.2, 0.3),
            {.kind = BodyKind::Static, .margin = settings.margin});
  const auto add = [&](const auto& body) {
    twins.add(body, tests::random_pose(source, reach), settings);
  };
  for (int i = 0; i < 4; ++i)
    add(tests::random_compound(source, 6, 0.6));
  for (int kind = 0; kind < 6; ++kind)
    add(tests::random_small_shape(source, kind));
}

Shape random_shape(RandomSource& source) {
  return tests::random_small_shape(source, static_cast<int>(source.integer(0, 5)));
}

TEST(CompoundWorld, MeetsWhatItsPartsMeet) {
  for (const double margin : {0.0, 0.05}) {
    std::size_t contacts = 0;
    for (unsigned seed = 0; seed < 3; ++seed) {
      RandomSource source(seed);
      Twins twins({});
      fill(twins, source, 2, {.margin = margin});
      for (int step = 0; step < 20; ++step) {
        contacts += twins.update();
        for (std::uint32_t body = 1; body < twins.size(); ++body) {
          if (source.uniform(0, 1) < 0.6)
            twins.move(body, tests::moved(source, twins.pose(body), 0.3, 0.5));
        }
        if (HasFailure()) return;
      }
    }
    EXPECT_GT(contacts, 500u);
  }
}

TEST(CompoundWorld, AnswersAsItsPartsDo) {
  std::size_t answers = 0;
  RandomSource source(7);
  Twins twins({});
  fill(twins, source, 2);
  for (int i = 0; i < 120 && !HasFailure(); ++i) {
    const Shape asked = random_shape(source);
    const Pose pose = tests::random_pose(source, 3);
    answers += twins.ask(asked, pose, source.uniform(0, 1) < 0.2 ? 0 : source.uniform(0, 1.5));
    const Eigen::Vector3d from = source.vector(-8, 8), to = source.vector(-2, 2);
    answers += twins.cast_ray({from, to - from});
    const Pose start = tests::random_pose(source, 5), end = tests::random_pose(source, 5);
    answers += twins.cast(random_shape(source), RigidMotion::between(start, end));
  }
  EXPECT_GT(answers, 300u);
}

/// Rays from near and far, along axes and through corners, at compounds near and far.
TEST(CompoundWorld, RaysMissNoPartWhereverTheyBegin) {
  RandomSource source(11);
  for (const double place : {0.0, 1e3, 1e9}) {
    Twins twins({});
    Compound boxes;
    for (int x = 0; x < 5; ++x)
      for (int y = 0; y < 5; ++y)
        for (int z = 0; z < 5; ++z)
          boxes.add({Box{{0.25, 0.25, 0.25}}, at(x - 2, y - 2, z - 2)});
    Pose pose = tests::random_pose(source, 0);
    pose.translation() = Eigen::Vector3d(place, -place, place / 2);
    twins.add(boxes, place == 0 ? at(0) : pose);
    std::size_t hits = 0;
    for (const double far : {1.0, 10.0, 1e4, 1e8}) {
      for (int i = 0; i < 25 && !HasFailure(); ++i) {
        const Eigen::Vector3d side = tests::random_pose(source, 0).linear().col(0);
        const Eigen::Vector3d to = twins.pose(0) * Eigen::Vector3d(source.lattice_point(-2, 2));
        const Eigen::Vector3d corner =
            twins.pose(0) * (source.lattice_point(-2, 2) + Eigen::Vector3d::Constant(0.25));
        hits += twins.cast_ray({to + far * side, -side});
        hits += twins.cast_ray({corner + far * side, -1e-200 * side});
        hits += twins.cast_ray({to + Eigen::Vector3d(0, 0, far), {0, 0, -1e200}, far});
      }
    }
    EXPECT_GT(hits, 100u);
  }
}

/// Filters of parts, or of their bodies, as the filters of bodies.
TEST(CompoundWorld, PartsHaveFilters) {
  RandomSource source(5);
  Twins twins({});
  const auto filter = [&] {
    return Filter{.category = static_cast<std::uint32_t>(source.integer(1, 3)),
                  .mask = static_cast<std::uint32_t>(source.integer(1, 3))};
  };
  const auto with_filters = [&](std::uint32_t parts, double radius) {
    Compound compound = tests::random_compound(source, parts, radius);
    for (const std::uint32_t part : compound.parts()) {
      if (part % 3 != 0) compound.set_settings(part, {.filter = filter(), .user_data = part});
    }
    return compound;
  };
  twins.add(with_filters(30, 1), at(0), {.kind = BodyKind::Static});
  for (int i = 0; i < 5; ++i)
    twins.add(with_filters(6, 0.5), tests::random_pose(source, 1));
  for (int i = 0; i < 5; ++i) {
    const Shape added = random_shape(source);
    twins.add(added, tests::random_pose(source, 1));
  }
  std::size_t contacts = 0;
  for (int step = 0; step < 8 && !HasFailure(); ++step) {
    contacts += twins.update();
    for (std::uint32_t body = 1; body < twins.size(); ++body)
      twins.move(body, tests::moved(source, twins.pose(body), 0.2, 0.5));
  }
  EXPECT_GT(contacts, 100u);
  const BodyQuerySettings asked{.filter = Filter{.category = 4, .mask = 4}};
  const Ray ray{{9, 0.1, 0}, {-1, 0, 0}};
  Compound two;
  two.add({Sphere{{0, 0, 0}, 1}, at(2)}, {.filter = Filter{.category = 2}});
  two.add({Sphere{{0, 0, 0}, 1}, at(-2)}, {.filter = Filter{.category = 4}});
  World world;
  const BodyId id = world.add({share(two), at(0)}, {.filter = {.category = 6}});
  ASSERT_TRUE(world.cast_ray(ray, asked));
  EXPECT_EQ(world.cast_ray(ray)->part, 0u);
  EXPECT_EQ(world.cast_ray(ray, asked)->part, 1u);
  const Shape ball = Sphere{{0, 0, 0}, 0.5};
  EXPECT_EQ(world.find_closest({ball, at(9)}, asked)->part, 1u);
  EXPECT_TRUE(world.find_touching({ball, at(2)}, asked).empty());
  EXPECT_EQ(world.find_touching({ball, at(-2)}, asked), std::vector{id});
  const RigidMotion shot(at(9), {.shift = {-18, 0, 0}});
  EXPECT_EQ(world.cast({ball, shot})->part, 0u);
  EXPECT_EQ(world.cast({ball, shot}, {}, asked)->part, 1u);
}

/// Parts that come, go and change, in a body that lies in a heap.
TEST(CompoundWorld, PartsAreAddedReplacedAndRemovedOneByOne) {
  RandomSource source(3);
  Twins twins({});
  fill(twins, source, 1.5);
  std::size_t contacts = 0;
  for (int step = 0; step < 40 && !HasFailure(); ++step) {
    const auto body = static_cast<std::uint32_t>(source.integer(0, 4));
    Compound changed = twins.compound(body);
    const std::vector<std::uint32_t> parts = changed.parts();
    const std::uint32_t part =
        parts[static_cast<std::size_t>(source.integer(0, 1000)) % parts.size()];
    const PlacedShape next{random_shape(source), tests::random_pose(source, 1)};
    if (step % 3 == 0) changed.add(next);
    if (step % 3 == 1) changed.replace(part, next);
    if (step % 3 == 2 && parts.size() > 1) changed.remove(part);
    twins.set_compound(body, changed);
    contacts += twins.update();
  }
  EXPECT_GT(contacts, 500u);
}

/// A ball that knows when two of it touch, and no more than a user's class has to.
TEST(CompoundWorld, MeetsAUsersOwnShapePartByPart) {
  for (const int threads : {1, 3}) {
    World world({.threads = threads});
    Compound rail;
    for (int i = 0; i < 20; ++i)
      rail.add({Box{{0.25, 0.5, 0.5}}, at(i)});
    const BodyId body = world.add({share(rail), at(0)});
    const auto ball = std::make_shared<tests::UsersBall>(0.25);
    std::vector<BodyId> balls;
    for (int i = 0; i < 19; ++i)
      balls.push_back(world.add({ball, at(i + (i % 3 == 0 ? 0.5 : 0.375))}));
    const WorldUpdate update = world.update();
    std::size_t touching = 0;
    for (int i = 0; i < 19; ++i) {
      const std::size_t parts = i % 3 == 0 ? 2 : 1;  // it touches both of its neighbours exactly
      const std::vector<BodyContact> contacts = world.contacts(balls[static_cast<std::size_t>(i)]);
      ASSERT_EQ(contacts.size(), parts) << i;
      for (std::size_t k = 0; k < parts; ++k)
        EXPECT_EQ(contacts[k].manifold.part_a(), static_cast<std::uint32_t>(i) + k);
      touching += parts;
    }
    EXPECT_EQ(update.contacts.size(), touching);
    EXPECT_EQ(world.touching(body), balls);
  }
}

TEST(CompoundWorldThreads, SayTheSame) {
  std::vector<BodyContact> of_one;
  for (const int threads : {1, 2, 4}) {
    RandomSource source(21);
    World world({.threads = threads});
    std::vector<BodyId> ids;
    for (int i = 0; i < 40; ++i)
      ids.push_back(
          world.add({share(tests::random_compound(source, 8, 1)), tests::random_pose(source, 2)}));
    std::vector<BodyContact> all;
    for (int step = 0; step < 4; ++step) {
      const WorldUpdate update = world.update();
      all.insert(all.end(), update.contacts.begin(), update.contacts.end());
      EXPECT_EQ(update.work.contacts_skipped, 0u);
      EXPECT_EQ(update.work.contacts_found, update.moved.size());
      for (const BodyId id : ids)
        world.move(id, tests::moved(source, world.pose(id), 0.2, 0.2));
    }
    if (threads == 1) of_one = all;
    EXPECT_GT(all.size(), 500u);
    EXPECT_TRUE(all == of_one) << threads;
  }
}

/// Boxes that touch face to face and edge to edge, to the last bit.
TEST(CompoundWorld, TouchesExactly) {
  Twins twins({});
  Compound steps;
  for (int i = 0; i < 40; ++i)
    steps.add({Box{{0.5, 2, 0.25}}, at(i, 0, 0.5 * i)});
  twins.add(steps, at(0), {.kind = BodyKind::Static});
  Compound pair;
  pair.add({Box{{0.25, 0.25, 0.25}}, at(0.5)});
  pair.add({Sphere{{0, 0, 0}, 0.25}, at(-0.5)});
  const std::uint32_t body = twins.add(pair, at(9, 0, 9));
  std::size_t contacts = 0;
  for (int i = 0; i < 12; ++i) {
    twins.move(body, at(3 + 0.25 * i, 0.5, 2.5));
    contacts += twins.update();
    twins.move(body, at(3 + 0.25 * i, 2.25, 2.0));
    contacts += twins.update();
  }
  EXPECT_GT(contacts, 20u);
}

TEST(CompoundWorld, IsSweptPartByPart) {
  std::size_t met = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    RandomSource source(100 + seed);
    Twins twins({});
    fill(twins, source, 4, {.detection = Detection::Continuous});
    twins.update();
    for (std::uint32_t body = 1; body < twins.size(); ++body) {
      const Pose& from = twins.pose(body);
      twins.move(body, RigidMotion(from, {.centre = from.translation(),
                                          .shift = source.vector(-5, 5),
                                          .axis = source.vector(-1, 1),
                                          .angle = body % 2 == 0 ? 0 : source.uniform(-2, 2)}));
    }
    // Where they have come to poses differ in their last bits: only ways are compared.
    met += twins.update_ways();
  }
  EXPECT_GT(met, 20u);
}

}  // namespace
}  // namespace graze
