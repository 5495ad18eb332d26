// Worlds and threads. Questions are const: any number of threads may put them. Worlds that share
// shapes are worlds of their own. Trees are built beforehand: that many threads may be the first to
// walk one is shown by MeshThreads, and oneTBB's own memory, which ThreadSanitizer cannot follow,
// is left alone here.

#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/engine/histories/history.h"

namespace graze::tests {
namespace {

constexpr std::size_t kThreads = 6;

/// Adds and moves of a history.
void play_part(World& world, const std::vector<std::shared_ptr<const BodyShape>>& shapes,
               std::size_t count) {
  std::vector<BodyId> ids(1);
  for (const Operation& operation : random_history(Setting::Crowd, 3, count).operations) {
    if (operation.verb == Verb::Add) {
      ids.resize(operation.body + 1);
      ids[operation.body] = world.add({shapes[operation.number], operation.pose});
    } else if (operation.verb == Verb::Move || operation.verb == Verb::MoveToo) {
      world.move(ids[operation.body], operation.pose);
    } else if (operation.verb == Verb::Update) {
      world.update();
    }
  }
  world.update();
}

const std::vector<Shape>& palette() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> all = palette_of(Setting::Crowd);
    for (const Shape& shape : all) {
      if (const Mesh* mesh = shape.as<Mesh>()) {
        prepare(*mesh);
        tree_of(*mesh);
      }
    }
    return all;
  }();
  return shapes;
}

std::vector<std::shared_ptr<const BodyShape>> shared_palette() {
  std::vector<std::shared_ptr<const BodyShape>> shapes;
  for (const Shape& shape : palette())
    shapes.push_back(share(shape));
  return shapes;
}

template <typename Work>
void on_all_threads(const Work& work) {
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kThreads; ++i)
    threads.emplace_back([&work, i] { work(i); });
  for (std::thread& thread : threads)
    thread.join();
}

struct Answers {
  std::vector<BodyId> touching, in_box;
  std::vector<BodyPair> pairs;
  std::size_t contacts = 0, near = 0, along = 0;
  double least = 0, first = 0;
  friend bool operator==(const Answers&, const Answers&) = default;
};

Answers ask(const World& world) {
  const Pose pose = Pose::Identity();
  Answers answers;
  answers.touching = world.find_touching({palette()[0], pose});
  answers.in_box = world.find_in_box({{-1, -1, -1}, {1, 1, 1}});
  answers.pairs = world.pairs();
  answers.contacts = world.contacts().size();
  answers.near = world.find_within({palette()[11], pose}, 0.5).size();
  answers.least = world.find_closest({palette()[6], pose})->distance.distance;
  answers.along = world.cast_ray_all({{-9, 0, 0}, {1, 0, 0}}).size();
  answers.first = world.cast_ray({{-9, 0, 0}, {1, 0, 0}})->hit.distance;
  EXPECT_NO_THROW(world.snapshot());
  return answers;
}

TEST(WorldThreads, ManyAskOneWorldAtOnce) {
  World world({.threads = 2, .contacts = false});
  play_part(world, shared_palette(), 600);
  std::vector<Answers> answers(kThreads);
  on_all_threads([&](std::size_t i) { answers[i] = ask(world); });
  EXPECT_FALSE(answers[0].pairs.empty());
  EXPECT_FALSE(answers[0].touching.empty());
  for (const Answers& each : answers)
    EXPECT_EQ(each, answers[0]);
}

TEST(WorldThreads, WorldsThatShareShapesStepAtOnce) {
  const auto shapes = shared_palette();
  std::vector<std::vector<BodyPair>> pairs(kThreads);
  on_all_threads([&](std::size_t i) {
    World world;
    play_part(world, shapes, 600);
    pairs[i] = world.pairs();
  });
  EXPECT_FALSE(pairs[0].empty());
  for (const auto& each : pairs)
    EXPECT_EQ(each, pairs[0]);
}

/// A snapshot may go to another world, of another thread.
TEST(WorldThreads, WorldsGoOnFromOneSnapshot) {
  World world;
  play_part(world, shared_palette(), 600);
  const WorldSnapshot snapshot = world.snapshot();
  std::vector<std::vector<BodyPair>> pairs(kThreads);
  on_all_threads([&](std::size_t i) {
    World mine;
    mine.restore(snapshot);
    play_part(mine, shared_palette(), 100);
    pairs[i] = mine.pairs();
  });
  for (const auto& each : pairs)
    EXPECT_EQ(each, pairs[0]);
}

}  // namespace
}  // namespace graze::tests
