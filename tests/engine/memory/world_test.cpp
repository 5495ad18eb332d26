// What a world holds for each body, for each pair and for each contact.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include "tests/engine/body_world/allocations.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

constexpr int kSide = 24, kHeight = 12;
constexpr double kBodies = double{kSide} * kSide * kHeight;

struct Held {
  double bytes;
  double pairs;
};

/// Boxes of one metre whose centres are `apart` metres from each other along three axes.
Held held_by_boxes(double apart, const WorldSettings& settings) {
  const auto before = static_cast<double>(tests::allocated_bytes());
  World world(settings);
  for (int x = 0; x < kSide; ++x)
    for (int y = 0; y < kSide; ++y)
      for (int z = 0; z < kHeight; ++z)
        world.add({Box{{0.5, 0.5, 0.5}}, tests::at(apart * x, apart * y, apart * z)});
  world.update();
  const double bytes = static_cast<double>(tests::allocated_bytes()) - before;
  return {bytes, static_cast<double>(world.contacts().size())};
}

TEST(WorldMemory, IsWhatThePageSays) {
  const Held loose = held_by_boxes(1.5, {.contacts = true});
  EXPECT_EQ(loose.pairs, 0);
  EXPECT_LE(loose.bytes / kBodies, 550);
  EXPECT_GE(loose.bytes / kBodies, 300) << "a shape and two poses alone take as much";

  const Held touching = held_by_boxes(0.999, {.contacts = false});
  ASSERT_GT(touching.pairs, 10 * kBodies);
  EXPECT_LE((touching.bytes - loose.bytes) / touching.pairs, 200);

  const Held listed = held_by_boxes(0.999, {.contacts = true});
  EXPECT_EQ(listed.pairs, touching.pairs);
  EXPECT_LE((listed.bytes - touching.bytes) / listed.pairs, 3 * sizeof(BodyContact));
  EXPECT_GE((listed.bytes - touching.bytes) / listed.pairs, sizeof(BodyContact));
  EXPECT_EQ(sizeof(BodyContact), 560u);
  EXPECT_EQ(sizeof(ShapeContact), 128u);
}

}  // namespace
}  // namespace graze
