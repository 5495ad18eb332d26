// A contact tracker beside a list of who should have which number: many pairs that come, go, stay
// and are not listed, and a body that goes from one part of a compound to the next.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/contact_tracker.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using tests::at;

TEST(ContactTracker, ManyPairsKeepTheirOwnNumbers) {
  RandomSource source(1541);
  World world;
  ContactTracker tracker;
  world.add({HalfSpace{{0, 0, 1}}}, {.kind = BodyKind::Static});
  constexpr int kBalls = 24;
  std::vector<BodyId> balls;
  for (int i = 0; i < kBalls; ++i)
    balls.push_back(world.add({Sphere{{0, 0, 0}, 0.25}, at(i, 0, 1)}));
  std::vector<bool> is_down(kBalls, false);
  std::map<BodyId, std::uint64_t> number_of;  // of those that lie on the ground
  std::set<std::uint64_t> given;
  int stayed = 0, begun = 0;
  for (int step = 0; step < 300; ++step) {
    for (int i = 0; i < kBalls; ++i) {
      const auto choice = source.integer(0, 5);
      if (choice < 3) continue;  // it is not moved, and its pair is not listed
      is_down[static_cast<std::size_t>(i)] = choice != 3;
      const double aside = source.uniform(0, 1e-6);
      world.move(balls[static_cast<std::size_t>(i)], at(i + aside, 0, choice == 3 ? 1 : 0.2499));
    }
    const WorldUpdate update = world.update();
    tracker.take(world, update);
    for (int i = 0; i < kBalls; ++i) {
      if (!is_down[static_cast<std::size_t>(i)])
        number_of.erase(balls[static_cast<std::size_t>(i)]);
    }
    for (std::size_t k = 0; k < update.contacts.size(); ++k) {
      const auto ids = tracker.ids(k);
      ASSERT_EQ(ids.size(), 1u);
      const BodyId ball = update.contacts[k].pair.b;
      const auto known = number_of.find(ball);
      if (known != number_of.end()) {
        ASSERT_EQ(ids[0], known->second) << step;
        ++stayed;
      } else {
        ASSERT_TRUE(given.insert(ids[0]).second) << step;
        number_of[ball] = ids[0];
        ++begun;
      }
    }
  }
  EXPECT_GT(stayed, 500);
  EXPECT_GT(begun, 200);
}

// Both parts end flush: the ball meets the next one where it met the first.
TEST(ContactTracker, AnotherPartOfACompoundHasOtherContacts) {
  World world;
  ContactTracker tracker;
  Compound floor;
  for (const double x : {-0.5, 0.5})
    floor.add({Box{{0.5, 0.5, 0.5}}, at(x, 0, -0.5)});
  world.add(PlacedBodyShape{share(floor), at(0, 0, 0)}, {.kind = BodyKind::Static});
  const double deep = 1e-9;  // so that it meets one part only, but for a hair about the seam
  const BodyId ball = world.add({Sphere{{0, 0, 0}, 0.25}, at(-1e-3, 0, 0.25 - deep)});
  std::vector<std::uint64_t> numbers;
  for (const double x : {-1e-3, 1e-3, 1.1e-3}) {
    world.move(ball, at(x, 0, 0.25 - deep));
    const WorldUpdate update = world.update();
    tracker.take(world, update);
    ASSERT_EQ(update.contacts.size(), 1u);
    ASSERT_EQ(tracker.ids(0).size(), 1u);
    numbers.push_back(tracker.ids(0)[0]);
  }
  EXPECT_NE(numbers[0], numbers[1]);
  EXPECT_EQ(numbers[1], numbers[2]);
}

}  // namespace
}  // namespace graze
