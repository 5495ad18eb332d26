// The id of a body that is gone, or never was, is refused by name wherever it can be given.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace graze {
namespace {

struct Call {
  const char* name;
  std::function<void(World&, BodyId)> make;
};

const std::vector<Call>& calls() {
  static const Pose origin = Pose::Identity();
  static const Shape ball = Sphere{{0, 0, 0}, 1};
  // The first body of the world is there.
  static const auto other = [](World& world) { return world.add({ball, origin}); };
  static const std::vector<Call> all = {
      {"remove", [](World& w, BodyId id) { w.remove(id); }},
      {"move", [](World& w, BodyId id) { w.move(id, origin); }},
      {"move",
       [](World& w, BodyId id) {
         const std::vector<BodyId> ids{other(w), id};
         w.move(ids, std::vector<Pose>{origin, origin});
       }},
      {"set_shape", [](World& w, BodyId id) { w.set_shape(id, ball); }},
      {"set_filter", [](World& w, BodyId id) { w.set_filter(id, {}); }},
      {"set_kind", [](World& w, BodyId id) { w.set_kind(id, BodyKind::Static); }},
      {"set_role", [](World& w, BodyId id) { w.set_role(id, Role::Sensor); }},
      {"set_user_data", [](World& w, BodyId id) { w.set_user_data(id, 1); }},
      {"sleep", [](World& w, BodyId id) { w.sleep(id); }},
      {"wake", [](World& w, BodyId id) { w.wake(id); }},
      {"exclude", [](World& w, BodyId id) { w.exclude(other(w), id); }},
      {"exclude", [](World& w, BodyId id) { w.exclude(id, other(w)); }},
      {"include", [](World& w, BodyId id) { w.include(other(w), id); }},
      {"include", [](World& w, BodyId id) { w.include(id, other(w)); }},
      {"pose", [](World& w, BodyId id) { w.pose(id); }},
      {"kind", [](World& w, BodyId id) { w.kind(id); }},
      {"role", [](World& w, BodyId id) { w.role(id); }},
      {"filter", [](World& w, BodyId id) { w.filter(id); }},
      {"user_data", [](World& w, BodyId id) { w.user_data(id); }},
      {"is_awake", [](World& w, BodyId id) { w.is_awake(id); }},
  };
  return all;
}

void expect_refused(World& world, BodyId id) {
  EXPECT_FALSE(world.contains(id));
  for (const Call& call : calls()) {
    try {
      call.make(world, id);
      ADD_FAILURE() << call.name << " takes it";
    } catch (const StaleIdError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(call.name), 0u) << what;
      EXPECT_NE(what.find(std::to_string(id.index)), std::string::npos) << what;
      EXPECT_NE(what.find(std::to_string(id.generation)), std::string::npos) << what;
    }
  }
}

TEST(WorldIds, StaleOnesAreRefusedEverywhere) {
  World world;
  expect_refused(world, {});
  expect_refused(world, {0, 0});
  expect_refused(world, {1000, 1});
  const BodyId first = world.add({Sphere{{0, 0, 0}, 1}, Pose::Identity()});
  expect_refused(world, {first.index, first.generation + 1});
  expect_refused(world, {first.index, first.generation + 2});
  world.remove(first);
  expect_refused(world, first);
  world.update();
  expect_refused(world, first);
}

TEST(WorldIds, AnIndexThatIsUsedAgainHasAnotherGeneration) {
  World world;
  const BodyId first = world.add({Sphere{{0, 0, 0}, 1}, Pose::Identity()});
  world.remove(first);
  world.update();
  world.update();
  const BodyId second = world.add({Sphere{{0, 0, 0}, 1}, Pose::Identity()});
  EXPECT_EQ(second.index, first.index);
  EXPECT_NE(second.generation, first.generation);
  EXPECT_TRUE(world.contains(second));
  expect_refused(world, first);
}

TEST(WorldIds, AFailedCallLeavesTheWorldAsItWas) {
  World world;
  const BodyId a = world.add({Sphere{{0, 0, 0}, 1}, Pose::Identity()});
  world.update();
  Pose away = Pose::Identity();
  away.translation().x() = 9;
  EXPECT_THROW(world.move(std::vector<BodyId>{a, {}}, std::vector<Pose>{away, away}), StaleIdError);
  EXPECT_THROW(world.move(std::vector<BodyId>{a}, std::vector<Pose>{}), InputError);
  EXPECT_THROW(world.exclude(a, a), InputError);
  EXPECT_EQ(world.pose(a).translation().x(), 0);
  EXPECT_EQ(world.find_in_box({{-1, -1, -1}, {1, 1, 1}}).size(), 1u);
  EXPECT_NO_THROW(world.snapshot());
}

/// A body that comes and goes in each step: its index has more users than 16 bits can count.
TEST(WorldIds, AnIndexIsUsedAgainManyTimes) {
  World world({.contacts = false});
  const auto ball = share(Sphere{{0, 0, 0}, 1});
  std::uint32_t largest = 0;
  for (int i = 0; i < 140000; ++i) {
    const BodyId id = world.add({ball, Pose::Identity()});
    largest = std::max(largest, id.index);
    world.remove(id);
    world.update();
  }
  EXPECT_LT(largest, 3u);
}

}  // namespace
}  // namespace graze
