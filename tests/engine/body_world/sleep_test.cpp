// What sleeps costs nothing, and is heard of where something awake meets it.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::at;

using Pairs = std::vector<BodyPair>;

Pairs list(std::span<const BodyPair> pairs) {
  return {pairs.begin(), pairs.end()};
}

/// Three boxes in a row on a floor, each touching the next, and the update that has seen them.
struct Row {
  explicit Row(const WorldSettings& settings = {}) : world(settings) {
    floor = world.add({HalfSpace{{0, 0, 1}, 0}, at(0)}, {.kind = BodyKind::Static});
    for (int i = 0; i < 3; ++i)
      box[i] = world.add({Box{{0.5, 0.5, 0.5}}, at(i, 0, 0.5)});
    world.update();
  }
  BodyPair pair(int i, int j) const { return {box[i], box[j]}; }
  BodyPair on_floor(int i) const { return {floor, box[i]}; }
  void sleep() {
    for (const BodyId id : box)
      world.sleep(id);
  }

  World world;
  BodyId floor, box[3];
};

TEST(WorldSleep, WhatIsAsleepIsNotLookedAt) {
  for (const bool skip : {true, false}) {
    Row row({.skip_apart = skip, .skip_at_rest = skip});
    row.sleep();
    row.world.move(row.box[2], at(1.9, 0, 0.5));
    row.world.sleep(row.box[2]);
    row.world.set_filter(row.box[0], {.category = 2});
    const WorldUpdate update = row.world.update();
    EXPECT_TRUE(update.begun.empty() && update.ended.empty() && update.moved.empty());
    EXPECT_TRUE(update.contacts.empty());
    EXPECT_EQ(update.work.shape_tests, 0u);
    EXPECT_EQ(update.work.pairs_asleep, 4u);  // 0/1, 1/2 and those with the floor
    EXPECT_EQ(update.work.pairs_at_rest, 1u);
    EXPECT_EQ(row.world.update().work.pairs_at_rest, 5u);
  }
}

TEST(WorldSleep, AnAnswerStandsUntilOneWakesOrBoxesPart) {
  World world;
  const BodyId ball = world.add({Sphere{{0, 0, 0}, 0.5}, at(0)});
  const BodyId other = world.add({Sphere{{0, 0, 0}, 0.5}, at(0.9)});
  const Pairs pair{{ball, other}};
  EXPECT_EQ(list(world.update().begun), pair);
  world.sleep(ball);
  const auto put = [&](const Pose& pose) {
    world.move(other, pose);
    world.sleep(other);
    const WorldUpdate update = world.update();
    EXPECT_TRUE(update.begun.empty() && update.moved.empty());
    EXPECT_EQ(update.work.shape_tests, 0u);
    return list(update.ended);
  };
  const Pose across = at(0.8, 0.8);  // apart, and the boxes are not
  EXPECT_EQ(put(across), Pairs{});
  EXPECT_EQ(world.pairs(), pair);
  ASSERT_EQ(world.contacts().size(), 1u);
  EXPECT_TRUE(world.contacts()[0].manifold.empty());
  EXPECT_EQ(put(at(0.9)), Pairs{});
  EXPECT_EQ(put(at(1.1)), pair);  // the boxes part
  EXPECT_EQ(put(at(0.9)), Pairs{});
  EXPECT_EQ(world.pairs(), Pairs{});

  world.wake(ball);
  EXPECT_THROW(world.snapshot(), InputError);
  EXPECT_EQ(list(world.update().begun), pair);
  world.sleep(ball);
  EXPECT_EQ(put(across), Pairs{});
  world.wake(other);
  EXPECT_EQ(list(world.update().ended), pair);
}

TEST(WorldSleep, WhatWakesIsListedWithAllThatItTouches) {
  Row row;
  row.sleep();
  EXPECT_TRUE(row.world.update().moved.empty());
  row.world.wake(row.box[1]);
  EXPECT_TRUE(row.world.is_awake(row.box[1]));
  const WorldUpdate update = row.world.update();
  EXPECT_TRUE(update.begun.empty() && update.ended.empty());
  EXPECT_EQ(list(update.moved), (Pairs{row.on_floor(1), row.pair(0, 1), row.pair(1, 2)}));
  EXPECT_EQ(update.contacts.size(), 3u);
  EXPECT_EQ(update.work.pairs_asleep, 0u);
  row.world.wake(row.box[1]);  // it is awake: nothing
  EXPECT_TRUE(row.world.update().moved.empty());
}

TEST(WorldSleep, AMoverMeetsASleeperAndWakesNobody) {
  for (const BodyKind motion : {BodyKind::Dynamic, BodyKind::Kinematic, BodyKind::Static}) {
    Row row;
    row.sleep();
    const BodyId ball = row.world.add({Sphere{{0, 0, 0}, 0.5}, at(0, 0, 3)}, {.kind = motion});
    row.world.update();
    row.world.move(ball, at(0, 0, 1.4));
    const WorldUpdate hit = row.world.update();
    const BodyPair pair{row.box[0], ball};
    EXPECT_EQ(list(hit.begun), Pairs{pair});
    EXPECT_EQ(list(hit.moved), Pairs{pair});
    ASSERT_EQ(hit.contacts.size(), 1u);
    EXPECT_GT(hit.contacts[0].manifold[0].depth, 0.09);
    EXPECT_FALSE(row.world.is_awake(row.box[0]));
    // As long as it moves there it is listed, then no more; what leaves is in `ended`.
    row.world.move(ball, at(0, 0, 1.41));
    EXPECT_EQ(list(row.world.update().moved), Pairs{pair});
    EXPECT_TRUE(row.world.update().moved.empty());
    row.world.move(ball, at(0, 0, 3));
    EXPECT_EQ(list(row.world.update().ended), Pairs{pair});
    EXPECT_EQ(row.world.is_awake(ball), motion != BodyKind::Static);
  }
}

/// Bodies that come where others sleep, and are put to sleep at once, are found when one wakes.
TEST(WorldSleep, WhatComesAndSleepsAtOnceIsMetLater) {
  Row row;
  row.sleep();
  const BodyId late = row.world.add({Box{{0.5, 0.5, 0.5}}, at(0.5, 0, 1.4)});
  row.world.sleep(late);
  const WorldUpdate unseen = row.world.update();
  EXPECT_TRUE(unseen.begun.empty());
  EXPECT_EQ(unseen.work.pairs_asleep, 2u);
  row.world.wake(row.box[0]);
  const WorldUpdate seen = row.world.update();
  EXPECT_EQ(list(seen.begun), (Pairs{{row.box[0], late}}));
  EXPECT_EQ(list(seen.moved), (Pairs{row.on_floor(0), row.pair(0, 1), {row.box[0], late}}));
  row.world.wake(late);
  EXPECT_EQ(list(row.world.update().begun), (Pairs{{row.box[1], late}}));
}

/// What was known of a gap is not believed of another shape, though nobody looked meanwhile.
TEST(WorldSleep, AShapeTakenAsleepIsMetWhenItWakes) {
  World world;
  const BodyId cone = world.add({Cone{0.5, 0.5}, at(0, 0, 0)});
  const BodyId drum = world.add({Cylinder{0.5, 0.5}, at(0.9, 0.9, 0)});
  std::uint64_t apart = 0;
  for (int i = 0; i < 8; ++i) {
    world.move(cone, at(0, 0, 1e-6 * i));
    apart += world.update().work.pairs_apart;
  }
  ASSERT_GT(apart, 0u);
  world.sleep(drum);
  world.set_shape(cone, Cylinder{0.9, 0.5});
  world.sleep(cone);
  EXPECT_TRUE(world.update().begun.empty());
  world.wake(drum);
  EXPECT_EQ(world.update().begun.size(), 1u);
}

/// A filter needs no look: what it keeps apart ends asleep.
TEST(WorldSleep, AFilterEndsPairsOfSleepers) {
  Row row;
  row.sleep();
  row.world.exclude(row.box[0], row.box[1]);
  EXPECT_EQ(list(row.world.update().ended), Pairs{row.pair(0, 1)});
  row.world.include(row.box[0], row.box[1]);
  EXPECT_TRUE(row.world.update().begun.empty());
  row.world.wake(row.box[1]);
  EXPECT_EQ(list(row.world.update().begun), Pairs{row.pair(0, 1)});
}

/// A zone that never moves is awake, as one that is carried along is.
TEST(WorldSleep, ASensorSeesWhatIsPutToSleepInIt) {
  for (const BodyKind motion : {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic}) {
    World world;
    const BodyId zone = world.add({Box{{1, 1, 1}}, at(0)}, {.kind = motion, .role = Role::Sensor});
    const BodyId body = world.add({Sphere{{0, 0, 0}, 0.5}, at(5)});
    world.update();
    EXPECT_TRUE(world.is_awake(zone));
    world.move(body, at(0));
    world.sleep(body);
    EXPECT_EQ(world.update().begun.size(), 1u);
    world.sleep(zone);
    world.move(body, at(1.4));
    world.sleep(body);
    EXPECT_EQ(world.update().work.pairs_asleep, 1u);
  }
}

}  // namespace
}  // namespace graze
