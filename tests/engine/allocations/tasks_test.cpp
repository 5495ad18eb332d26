// Where oneTBB finds no memory for a task an update throws and has not happened, or this thread
// does what was to be shared: either way the next update makes up for it, and no pair is lost or
// told twice.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstddef>
#include <new>
#include <optional>
#include <vector>

#include "tests/engine/allocations/failing_tasks.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

constexpr int kPiles = 1500;

/// Two balls that touch, and one that comes near to both, many times over.
World make_piles() {
  World world({.threads = 4, .islands = true});
  for (int i = 0; i < kPiles; ++i) {
    const double x = 10.0 * i;
    world.add({Capsule{1, 0.5}, at(x)});
    world.add({Box{{1, 1, 1}}, at(x + 1.5, 0.25, 0.5)});
    world.add({Cylinder{1, 1}, at(x, 4, 0)});
  }
  return world;
}

struct Told {
  std::vector<BodyPair> begun;
  std::size_t contacts = 0;
};

/// What an update tells, if it ends.
std::optional<Told> told_by(World& world) {
  try {
    const WorldUpdate update = world.update();
    return Told{{update.begun.begin(), update.begun.end()}, update.contacts.size()};
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
}

TEST(Allocations, OfTasksMayFail) {
  const tbb::global_control few(tbb::global_control::max_allowed_parallelism, 4);
  World twin = make_piles();
  const Told expected = *told_by(twin);
  ASSERT_EQ(expected.begun.size(), static_cast<std::size_t>(kPiles));
  // How many there are depends on who is idle when.
  constexpr int kBeyondTheLast = 8;
  int ended = 0, thrown = 0, missed = 0;
  for (long n = 1; missed < kBeyondTheLast && !HasFailure(); ++n) {
    World world = make_piles();
    bool has_failed = false;
    std::optional<Told> told;
    {
      const FailingTasks armed(n);
      told = told_by(world);
      has_failed = armed.has_failed();
    }
    if (!has_failed) {
      ++missed;
      continue;
    }
    ++(told ? ended : thrown);
    const Told next = *told_by(world);
    if (told) {
      EXPECT_TRUE(next.begun.empty()) << n;
    } else {
      told = next;
    }
    EXPECT_EQ(told->begun, expected.begun) << n;
    EXPECT_EQ(told->contacts, expected.contacts) << n;
    EXPECT_EQ(world.pairs().size(), twin.pairs().size()) << n;
    EXPECT_EQ(world.islands().size(), twin.islands().size()) << n;
  }
  // Some of the tasks are those that take note of answers, which this thread then does.
  EXPECT_GT(ended, 0);
  EXPECT_GT(thrown, 0);
}

}  // namespace
}  // namespace graze::tests
