// What a world says at its doors: errors that name what was called and which element is bad, lists
// without bodies that are gone, and queries that ask for some bodies only.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::at;

template <typename Error, typename Call>
std::string what_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no such error";
}

bool begins_with(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

TEST(WorldDoors, ErrorsNameWhatWasCalled) {
  World world;
  const Ray nowhere{{0, 0, 0}, {0, 0, 0}, 1};
  EXPECT_TRUE(begins_with(what_of<InputError>([&] { world.cast_ray(nowhere); }), "cast_ray: "));
  EXPECT_TRUE(
      begins_with(what_of<InputError>([&] { world.cast_ray_all(nowhere); }), "cast_ray_all: "));
  EXPECT_TRUE(begins_with(what_of<InputError>([] { const World none({.threads = -1}); }),
                          "threads: -1 is"));
  EXPECT_TRUE(begins_with(what_of<InputError>([&] {
                            world.find_in_box({{1, 0, 0}, {0, 0, 0}});
                          }),
                          "find_in_box: "));
}

TEST(WorldDoors, WithinAnUpdateAWorldCannotBeChanged) {
  World world;
  const BodyId a = world.add({Sphere{{0, 0, 0}, 1}, at(0)});
  const BodyId b = world.add({Sphere{{0, 0, 0}, 1}, at(1)});
  const WorldSnapshot empty = World().snapshot();
  const std::vector<std::function<void()>> changes = {
      [&] {
        world.add({Sphere{{0, 0, 0}, 1}, at(2)});
      },
      [&] { world.remove(a); },
      [&] { world.move(a, at(5)); },
      [&] {
        world.move(std::array{a, b}, std::array{at(5), at(6)});
      },
      [&] {
        world.set_shape(a, Sphere{{0, 0, 0}, 2});
      },
      [&] { world.set_filter(a, {}); },
      [&] { world.set_kind(a, BodyKind::Static); },
      [&] { world.set_role(a, Role::Sensor); },
      [&] { world.set_user_data(a, 7); },
      [&] { world.sleep(a); },
      [&] { world.wake(a); },
      [&] { world.exclude(a, b); },
      [&] { world.include(a, b); },
      [&] { world.set_pair_filter({}); },
      [&] { world.update(); },
      [&] { world.restore(empty); }};
  std::size_t refused = 0;
  world.set_pair_filter([&](BodyId, BodyId) {
    for (const std::function<void()>& change : changes) {
      const std::string what = what_of<InputError>(change);
      EXPECT_NE(what.find(": the world is within an update"), std::string::npos) << what;
      ++refused;
    }
    EXPECT_EQ(world.find_touching({Sphere{{0, 0, 0}, 1}, at(0.5)}).size(), 2u);
    return true;
  });
  EXPECT_EQ(world.update().begun.size(), 1u);
  EXPECT_EQ(refused, changes.size());
  EXPECT_EQ(world.size(), 2u);
  world.remove(a);
  EXPECT_EQ(world.update().ended.size(), 1u);
}

/// A filter that throws at the n-th question loses nothing of what began and ended.
TEST(WorldDoors, AnUpdateThatIsCutShortIsMadeUpFor) {
  for (int lasts = 0; lasts < 12; ++lasts) {
    World world;
    std::vector<BodyId> ids;
    for (int i = 0; i < 8; ++i)
      ids.push_back(world.add({Sphere{{0, 0, 0}, 1}, at(1.5 * i)}));
    ASSERT_EQ(world.update().begun.size(), 7u);
    int left = lasts;
    world.set_pair_filter([&](BodyId s, BodyId t) {
      if (left-- == 0) throw std::runtime_error("no more");
      return s != ids[2] || t != ids[3];
    });
    world.remove(ids[6]);
    world.move(ids[0], at(7));
    const bool is_cut_short = what_of<std::runtime_error>([&] { world.update(); }) == "no more";
    if (is_cut_short) {
      EXPECT_THROW(world.contacts(), InputError);
      EXPECT_THROW(world.snapshot(), InputError);
      world.set_pair_filter([&](BodyId s, BodyId t) { return s != ids[2] || t != ids[3]; });
    }
    if (!is_cut_short) continue;
    const WorldUpdate update = world.update();
    using Pairs = std::vector<BodyPair>;
    const Pairs ended(update.ended.begin(), update.ended.end());
    EXPECT_EQ(ended,
              (Pairs{{ids[0], ids[1]}, {ids[2], ids[3]}, {ids[5], ids[6]}, {ids[6], ids[7]}}));
    const Pairs begun(update.begun.begin(), update.begun.end());
    EXPECT_EQ(begun, (Pairs{{ids[0], ids[4]}, {ids[0], ids[5]}}));
    EXPECT_EQ(world.pairs(), (Pairs{{ids[0], ids[4]},
                                    {ids[0], ids[5]},
                                    {ids[1], ids[2]},
                                    {ids[3], ids[4]},
                                    {ids[4], ids[5]}}));
    EXPECT_EQ(world.contacts().size(), 5u);
    EXPECT_TRUE(world.update().moved.empty());
  }
}

TEST(WorldDoors, AMoveOfManyIsAllOrNoneAndNamesTheBadOne) {
  World world;
  std::vector<BodyId> ids;
  for (int i = 0; i < 4; ++i)
    ids.push_back(world.add({Sphere{{0, 0, 0}, 1}, at(i)}));
  world.update();
  std::vector<Pose> poses(4, at(9));
  poses[2] = at(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(
      begins_with(what_of<PoseError>([&] { world.move(ids, poses); }), "move, element 2: "));
  EXPECT_TRUE(begins_with(what_of<PoseError>([&] { world.move(ids[2], poses[2]); }), "move: "));
  poses[2] = at(9);
  std::vector<BodyId> stale = ids;
  ++stale[3].generation;
  EXPECT_TRUE(
      begins_with(what_of<StaleIdError>([&] { world.move(stale, poses); }), "move, element 3: "));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(world.pose(ids[i]).translation().x(), static_cast<double>(i));
  world.snapshot();  // nothing waits
}

TEST(WorldDoors, PairsAreWithoutTheDead) {
  World world;
  std::vector<BodyId> row;
  for (int i = 0; i < 4; ++i)
    row.push_back(world.add({Sphere{{0, 0, 0}, 0.6}, at(i)}));
  world.update();
  ASSERT_EQ(world.pairs().size(), 3u);
  world.remove(row[1]);
  EXPECT_EQ(world.pairs(), (std::vector<BodyPair>{{row[2], row[3]}}));
  EXPECT_EQ(world.update().ended.size(), 2u);
  EXPECT_EQ(world.pairs(), (std::vector<BodyPair>{{row[2], row[3]}}));
}

/// Every query with every setting is the query of all, less who is not asked for.
TEST(WorldDoors, QueriesAskForSome) {
  World world;
  std::vector<BodyId> ids;
  for (int i = 0; i < 60; ++i) {
    const auto category = 1u << i % 3;
    ids.push_back(world.add(
        {Sphere{{0, 0, 0}, 0.4}, at(i % 5, i / 5 % 4, i / 20)},
        {.filter = {.category = category}, .role = i % 4 == 0 ? Role::Sensor : Role::Solid}));
  }
  world.update();
  const Sphere ball{{0, 0, 0}, 1.2};
  const Pose pose = at(1.8, 1.4, 0.9);
  const Aabb box{{0.5, 0.5, 0}, {3.2, 2.1, 1.2}};
  const BodyDistance all_closest = *world.find_closest({ball, pose});
  for (std::uint32_t mask = 0; mask < 8; ++mask) {
    for (const std::optional<Role> role :
         {std::optional<Role>(), std::optional(Role::Solid), std::optional(Role::Sensor)}) {
      const BodyQuerySettings query{.filter = Filter{.mask = mask}, .role = role};
      const auto is_asked_for = [&](BodyId id) {
        return (world.filter(id).category & mask) != 0 && (!role || world.role(id) == *role);
      };
      std::vector<BodyId> touching, in_box, near;
      for (const BodyId id : world.find_touching({ball, pose}))
        if (is_asked_for(id)) touching.push_back(id);
      for (const BodyId id : world.find_in_box(box))
        if (is_asked_for(id)) in_box.push_back(id);
      for (const BodyDistance& found : world.find_within({ball, pose}, 0.5))
        if (is_asked_for(found.id)) near.push_back(found.id);
      EXPECT_EQ(world.find_touching({ball, pose}, query), touching);
      EXPECT_EQ(world.find_in_box(box, query), in_box);
      std::vector<BodyId> found_near;
      for (const BodyDistance& found : world.find_within({ball, pose}, 0.5, query))
        found_near.push_back(found.id);
      EXPECT_EQ(found_near, near);
      EXPECT_EQ(touching.empty() || in_box.empty() || near.empty(), mask == 0);
      const auto closest = world.find_closest({ball, pose}, query);
      EXPECT_EQ(closest.has_value(), mask != 0);
      if (closest) {
        EXPECT_TRUE(is_asked_for(closest->id));
        EXPECT_GE(closest->distance.distance, all_closest.distance.distance);
      }
    }
  }
}

/// An exclusion ends with either body, and with none of the others.
TEST(WorldDoors, ExclusionsEndWithTheirBodies) {
  World world;
  std::vector<BodyId> ids;
  for (int i = 0; i < 5; ++i)
    ids.push_back(world.add({Sphere{{0, 0, 0}, 1}, at(0.1 * i)}));
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < i; ++j)
      world.exclude(ids[i], ids[j]);
  }
  EXPECT_TRUE(world.update().begun.empty());
  world.remove(ids[2]);
  for (int i = 0; i < 3; ++i)
    world.update();  // then its index is used again
  const BodyId late = world.add({Sphere{{0, 0, 0}, 1}, at(0.25)});
  EXPECT_EQ(late.index, ids[2].index);
  EXPECT_EQ(world.update().begun.size(), 4u);
  world.include(ids[0], ids[4]);
  EXPECT_EQ(world.update().begun.size(), 1u);
  world.remove(ids[0]), world.remove(ids[1]), world.remove(ids[3]), world.remove(ids[4]);
  EXPECT_EQ(world.update().ended.size(), 5u);
  EXPECT_EQ(world.size(), 1u);
}

}  // namespace
}  // namespace graze
