// Updates that threads share, and shapes of a user's own: which threads ask them, and what they
// throw.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/engine/body_world/users_ball.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::at;
using tests::UsersBall;

using Parallelism = tbb::global_control;
constexpr auto kMostAtOnce = Parallelism::max_allowed_parallelism;

/// Balls in a row, each touching the next two, of these shapes in turn.
std::vector<BodyId> add_row(World& world,
                            const std::vector<std::shared_ptr<const BodyShape>>& shapes) {
  std::vector<BodyId> ids;
  for (std::size_t i = 0; i < 200; ++i)
    ids.push_back(world.add({shapes[i % shapes.size()], at(0.9 * static_cast<double>(i))}));
  return ids;
}

/// Notes which threads ask it; those that it lets in wait until there are two, for a while.
class Meeting : public UsersBall {
 public:
  explicit Meeting(bool is_concurrent) : UsersBall(1, is_concurrent), does_wait_(is_concurrent) {}
  std::size_t threads() const {
    const std::lock_guard lock(mutex_);
    return threads_.size();
  }
  bool has_met(std::thread::id thread) const {
    const std::lock_guard lock(mutex_);
    return threads_.contains(thread);
  }

 private:
  void note() const override {
    {
      const std::lock_guard lock(mutex_);
      threads_.insert(std::this_thread::get_id());
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (does_wait_ && threads() < 2 && std::chrono::steady_clock::now() < end)
      std::this_thread::yield();
  }

  bool does_wait_;
  mutable std::mutex mutex_;
  mutable std::set<std::thread::id> threads_;
};

TEST(SharedUpdateThreads, AskUsersShapesOnlyIfTheyAllowIt) {
  const Parallelism enough(kMostAtOnce, 4);
  World world({.threads = 4});
  const auto anyones = std::make_shared<Meeting>(true), callers = std::make_shared<Meeting>(false);
  const std::vector<BodyId> ids = add_row(world, {anyones, anyones, callers});
  EXPECT_GT(world.update().moved.size(), ids.size());
  // Two threads were among the pairs at once, and both have met those that are not for them.
  EXPECT_GE(anyones->threads(), 2u);
  for (int i = 0; i < 3; ++i) {
    for (const BodyId id : ids)
      world.move(id, world.pose(id) * at(0, 0.01));
    EXPECT_GT(world.update().moved.size(), ids.size());
  }
  EXPECT_EQ(callers->threads(), 1u);
  EXPECT_TRUE(callers->has_met(std::this_thread::get_id()));
}

struct Refusal : std::runtime_error {
  explicit Refusal(double place) : std::runtime_error("refused"), where(place) {}
  double where;
};

/// Throws where one of two is beyond a place.
class Refuser : public UsersBall {
 public:
  explicit Refuser(bool is_concurrent) : UsersBall(1, is_concurrent) {}

  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    const double where = std::max(pose.translation().x(), other_pose.translation().x());
    if (where >= first_refused) throw Refusal(where);
    return UsersBall::touches(pose, other, other_pose);
  }

  double first_refused = 1e9;
};

using Pairs = std::vector<BodyPair>;

Pairs list(std::span<const BodyPair> pairs) {
  return {pairs.begin(), pairs.end()};
}

/// What a row of balls says, of which every other one leaves its place while updates are cut short.
struct Said {
  std::vector<double> thrown;
  Pairs begun, ended, moved;
  WorldWork work;
};

Said say(int threads, bool is_concurrent) {
  World world({.threads = threads});
  const auto shape = std::make_shared<Refuser>(is_concurrent);
  const std::vector<BodyId> ids = add_row(world, {shape});
  world.update();
  Said said;
  for (const double from : {150.0, 60.0, 90.0}) {
    shape->first_refused = from;
    for (std::size_t i = 0; i < ids.size(); i += 2)
      world.move(ids[i], world.pose(ids[i]) * at(0, from == 60 ? -2.5 : 2.5));
    try {
      world.update();
    } catch (const Refusal& refusal) {
      said.thrown.push_back(refusal.where);
    }
    EXPECT_THROW(world.contacts(), InputError);
  }
  shape->first_refused = 1e9;
  const WorldUpdate update = world.update();
  said.begun = list(update.begun), said.ended = list(update.ended);
  said.moved = list(update.moved), said.work = update.work;
  return said;
}

/// The first pair that throws is told of, and those before it have been taken note of, whoever
/// asked; the next update that comes to its end tells all.
TEST(SharedUpdateThreads, ThrowWhatTheFirstPairThrew) {
  const Parallelism enough(kMostAtOnce, 8);
  for (const bool is_concurrent : {true, false}) {
    const Said alone = say(1, is_concurrent);
    ASSERT_EQ(alone.thrown.size(), 3u);
    EXPECT_FALSE(alone.ended.empty());
    EXPECT_TRUE(alone.begun.empty());
    for (const int threads : {2, 4, 8}) {
      for (int repetition = 0; repetition < 5; ++repetition) {
        const Said shared = say(threads, is_concurrent);
        EXPECT_EQ(shared.thrown, alone.thrown) << threads;
        EXPECT_EQ(shared.begun, alone.begun) << threads;
        EXPECT_EQ(shared.ended, alone.ended) << threads;
        EXPECT_EQ(shared.moved, alone.moved) << threads;
        EXPECT_TRUE(shared.work == alone.work) << threads;
      }
    }
  }
}

/// Throws on any thread but the one that made it, once that thread has come.
class HomeBody : public UsersBall {
 public:
  HomeBody() : UsersBall(1, true) {}
  bool is_used_up() const { return has_thrown_; }

 private:
  void note() const override {
    if (std::this_thread::get_id() != home_) {
      if (!has_thrown_.exchange(true)) throw Refusal(0);
      return;
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!has_thrown_ && std::chrono::steady_clock::now() < end)
      std::this_thread::yield();
  }

  std::thread::id home_ = std::this_thread::get_id();
  mutable std::atomic<bool> has_thrown_ = false;
};

TEST(SharedUpdateThreads, ThrowToTheCallerWhatAnotherThreadThrew) {
  const Parallelism enough(kMostAtOnce, 4);
  World world({.threads = 4}), other;
  const auto shape = std::make_shared<HomeBody>();
  add_row(world, {shape});
  add_row(other, {share(Sphere{{0, 0, 0}, 1})});
  EXPECT_THROW(world.update(), Refusal);
  EXPECT_TRUE(shape->is_used_up());
  EXPECT_THROW(world.snapshot(), InputError);
  const Pairs begun = list(world.update().begun);
  EXPECT_EQ(begun, list(other.update().begun));
  EXPECT_GT(begun.size(), 300u);
}

/// Throws at two places, at the first one only once it has thrown at the second.
class Latecomer : public UsersBall {
 public:
  Latecomer() : UsersBall(1, true) {}

  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    const double where = std::min(pose.translation().x(), other_pose.translation().x());
    if (where > kSecond) {
      has_thrown_ = true;
      throw Refusal(kSecond);
    }
    if (where > kFirst && where < kFirst + 1) {
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
      while (!has_thrown_ && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
      throw Refusal(kFirst);
    }
    return UsersBall::touches(pose, other, other_pose);
  }
  bool has_thrown_at_second() const { return has_thrown_; }

  static constexpr double kFirst = 60, kSecond = 100;

 private:
  mutable std::atomic<bool> has_thrown_ = false;
};

TEST(SharedUpdateThreads, ThrowWhatTheFirstPairThrewHoweverLate) {
  const Parallelism enough(kMostAtOnce, 4);
  World world({.threads = 2});
  const auto shape = std::make_shared<Latecomer>();
  add_row(world, {shape});
  double where = 0;
  try {
    world.update();
  } catch (const Refusal& refusal) {
    where = refusal.where;
  }
  EXPECT_TRUE(shape->has_thrown_at_second());
  EXPECT_EQ(where, Latecomer::kFirst);
}

/// Balls come to meshes at rest, each with a tree of its own that nobody has built.
TEST(SharedUpdate, CountsTreesThatItBuilt) {
  for (const int threads : {1, 2}) {
    World world({.threads = threads});
    std::vector<BodyId> balls;
    constexpr int kMeshes = 80;
    for (int i = 0; i < kMeshes; ++i) {
      world.add({tests::make_sphere(1, 6, 8), at(5 * i)});
      balls.push_back(world.add({Sphere{{0, 0, 0}, 1}, at(5 * i, 10)}));
    }
    EXPECT_EQ(world.update().work.trees_unbuilt, std::uint64_t{kMeshes});
    for (int i = 0; i < kMeshes; ++i)
      world.move(balls[static_cast<std::size_t>(i)], at(5 * i, i % 2 == 0 ? 1 : 20));
    const WorldUpdate update = world.update();
    EXPECT_EQ(update.work.trees_unbuilt, std::uint64_t{kMeshes / 2}) << threads;
    EXPECT_EQ(update.work.shapes.trees_built, std::uint64_t{kMeshes / 2}) << threads;
    EXPECT_EQ(update.contacts.size(), std::uint64_t{kMeshes / 2}) << threads;
  }
}

}  // namespace
}  // namespace graze
