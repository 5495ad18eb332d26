// Islands beside a union-find over all touching pairs, from scratch, after each update of random
// histories; what one body touches; ids of other worlds.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

#include "tests/engine/broad_phase/box_histories.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using test::Chance;
using tests::at;

using Bodies = std::vector<BodyId>;
using BodySets = std::vector<Bodies>;

const Shape kBall = Sphere{{0, 0, 0}, 0.5};

/// The sets of bodies that pairs() and kinds say hang together, each ascending, by first bodies.
BodySets islands_from_scratch(const World& world) {
  const Bodies bodies = world.bodies();
  std::map<BodyId, BodyId> parent;
  const auto root = [&](BodyId id) {
    while (parent[id] != id)
      id = parent[id];
    return id;
  };
  const auto joins = [&](BodyId id) {
    return world.kind(id) == BodyKind::Dynamic && world.role(id) == Role::Solid;
  };
  for (const BodyId id : bodies)
    parent[id] = id;
  for (const auto& [a, b] : world.pairs()) {
    if (joins(a) && joins(b)) parent[std::max(root(a), root(b))] = std::min(root(a), root(b));
  }
  std::map<BodyId, Bodies> sets;
  for (const BodyId id : bodies) {
    if (joins(id)) sets[root(id)].push_back(id);
  }
  BodySets all;
  for (const auto& [first, set] : sets)
    all.push_back(set);
  return all;
}

/// A world in which everything changes that islands depend on.
class IslandHistory {
 public:
  IslandHistory(std::uint64_t seed, double size, int threads)
      : chance_(seed), size_(size), world_({.threads = threads, .islands = true}) {}

  void change() {
    const std::uint32_t what = chance_.below(24);
    if (bodies_.size() < 8 || (what < 3 && bodies_.size() < 60)) {
      const Pose pose = somewhere();  // drawn first: compilers order arguments as they like
      bodies_.push_back(world_.add({kBall, pose}, {.kind = kind(), .role = role()}));
      return;
    }
    const std::size_t which = chance_.below(static_cast<std::uint32_t>(bodies_.size()));
    const BodyId id = bodies_[which];
    if (what == 3) {
      world_.remove(id);
      bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(which));
    } else if (what == 4) {
      world_.set_kind(id, kind());
    } else if (what == 5) {
      world_.set_role(id, role());
    } else if (what == 6) {
      world_.set_filter(id, {.category = 1 + chance_.below(2), .mask = 1 + chance_.below(3)});
    } else if (what == 7) {
      world_.sleep(id);
    } else if (what == 8) {
      world_.wake(id);
    } else if (what == 9) {
      world_.set_shape(id, Sphere{{0, 0, 0}, 0.25 + 0.25 * chance_.below(3)});
    } else {
      world_.move(id, somewhere());
    }
  }

  void check() {
    world_.update();
    const BodySets wanted = islands_from_scratch(world_);
    ASSERT_EQ(world_.islands(), wanted);
    std::size_t joined = 0;
    for (const Bodies& island : wanted) {
      joined += island.size();
      EXPECT_EQ(world_.island(island[chance_.below(static_cast<std::uint32_t>(island.size()))]),
                island);
    }
    for (const BodyId id : bodies_)
      check_neighbours(id);
    largest_ = std::max(largest_, joined);
    many_ = std::max(many_, wanted.size());
  }

  void check_neighbours(BodyId id) {
    std::vector<BodyPair> pairs;
    Bodies touching;
    for (const BodyPair& pair : world_.pairs()) {
      if (pair.a != id && pair.b != id) continue;
      pairs.push_back(pair);
      touching.push_back(pair.a == id ? pair.b : pair.a);
    }
    ASSERT_EQ(world_.pairs(id), pairs);
    ASSERT_EQ(world_.touching(id), touching);
  }

  World& world() { return world_; }
  std::size_t largest() const { return largest_; }
  std::size_t many() const { return many_; }

 private:
  Pose somewhere() {
    const auto along = [&] { return 0.25 * chance_.below(static_cast<std::uint32_t>(size_)); };
    const double x = along(), y = along(), z = along();
    return at(x, y, z);
  }
  BodyKind kind() { return chance_.one_in(4) ? BodyKind(chance_.below(2)) : BodyKind::Dynamic; }
  Role role() { return chance_.one_in(8) ? Role::Sensor : Role::Solid; }

  Chance chance_;
  double size_;
  World world_;
  Bodies bodies_;
  std::size_t largest_ = 0, many_ = 0;
};

TEST(WorldIslands, AreThoseOfAUnionFindFromScratch) {
  std::size_t histories_of_many = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    IslandHistory history(seed, 6 + seed % 4 * 5.0, seed % 3 == 0 ? 3 : 1);
    std::optional<WorldSnapshot> saved;
    for (int step = 0; step < 60; ++step) {
      const int changes = step % 7 == 0 ? 40 : 4;
      for (int i = 0; i < changes; ++i)
        history.change();
      ASSERT_NO_FATAL_FAILURE(history.check()) << "seed " << seed << ", step " << step;
      if (step == 30) saved = history.world().snapshot();
    }
    EXPECT_GT(history.largest(), 10u);
    histories_of_many += history.many() > 2;
    history.world().restore(*saved);
    EXPECT_EQ(history.world().islands(), islands_from_scratch(history.world()));
  }
  EXPECT_GT(histories_of_many, 16u);  // of 24: in the densest nearly all bodies hang together
}

struct Row {
  explicit Row(int count, bool is_ring = false) : world({.islands = true}) {
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * 3.14159265358979323846 * i / count;
      const double radius = 0.45 / std::sin(3.14159265358979323846 / count);
      bodies.push_back(world.add(
          {kBall, is_ring ? at(radius * std::cos(angle), radius * std::sin(angle)) : at(0.9 * i)}));
    }
    world.update();
  }
  World world;
  Bodies bodies;
};

TEST(WorldIslands, CostWhatChanges) {
  Row row(1000);
  ASSERT_EQ(row.world.islands().size(), 1u);
  EXPECT_EQ(row.world.update().work.island_steps, 0u) << "nothing changed";
  row.world.move(row.bodies[998], at(0.9 * 998, 5));
  WorldWork work = row.world.update().work;
  EXPECT_EQ(work.islands_split, 2u);  // the body, and the last one
  EXPECT_LE(work.island_steps, 24u);
  row.world.move(row.bodies[998], at(0.9 * 998));
  work = row.world.update().work;
  EXPECT_EQ(work.islands_merged, 2u);
  EXPECT_LE(work.island_steps, 24u) << "the smaller one is relabelled";
  EXPECT_EQ(row.world.islands().size(), 1u);

  Row ring(100, true);
  ring.world.remove(ring.bodies[7]);
  work = ring.world.update().work;
  EXPECT_EQ(ring.world.islands().size(), 1u);
  EXPECT_LE(work.island_steps, 1000u) << "once around";

  World without;
  without.add({kBall, at(0)}), without.add({kBall, at(0.5)});
  work = without.update().work;
  EXPECT_EQ(work.islands_merged + work.island_steps, 0u);
  EXPECT_THROW(without.islands(), InputError);
  EXPECT_THROW(without.island(without.bodies()[0]), InputError);
}

TEST(WorldIslands, StaticBodiesJoinNoneAndNoneToAnother) {
  World world({.islands = true});
  const BodyId floor = world.add({Box{{9, 9, 0.5}}, at(0)}, {.kind = BodyKind::Static});
  const BodyId a = world.add({kBall, at(0, 0, 0.9)}), b = world.add({kBall, at(3, 0, 0.9)});
  const BodyId zone = world.add({Box{{9, 9, 1}}, at(0)}, {.role = Role::Sensor});
  EXPECT_TRUE(world.islands().empty()) << "no update has seen them";
  EXPECT_TRUE(world.island(a).empty());
  world.update();
  EXPECT_EQ(world.islands(), (BodySets{{a}, {b}}));
  EXPECT_TRUE(world.island(floor).empty() && world.island(zone).empty());
  EXPECT_EQ(world.touching(floor), (Bodies{a, b}));
  EXPECT_EQ(world.touching(zone), (Bodies{a, b}));
  EXPECT_EQ(world.contacts(a).size(), 1u) << "sensors have none";
  EXPECT_EQ(world.contacts(floor), world.contacts());
  world.set_kind(floor, BodyKind::Dynamic);
  EXPECT_EQ(world.islands(), (BodySets{{a}, {b}})) << "as the last update found them";
  EXPECT_THROW(world.contacts(a), InputError);
  world.update();
  EXPECT_EQ(world.islands(), (BodySets{{floor, a, b}}));
  EXPECT_EQ(world.bodies({.role = Role::Sensor}), Bodies{zone});
  world.remove(floor);
  EXPECT_EQ(world.islands(), (BodySets{{a, b}})) << "without what was removed since";
  world.update();
  EXPECT_EQ(world.islands(), (BodySets{{a}, {b}}));
}

TEST(WorldIslands, GoToSleepAndWakeAsAWhole) {
  Row row(5);
  const BodyId apart = row.world.add({kBall, at(0, 9)});
  row.world.update();
  row.world.sleep(row.world.island(row.bodies[2]));
  for (const BodyId id : row.bodies)
    EXPECT_FALSE(row.world.is_awake(id));
  EXPECT_TRUE(row.world.is_awake(apart));
  row.world.update();
  EXPECT_EQ(row.world.islands(), (BodySets{row.bodies, {apart}}));
  row.world.move(apart, at(0, 0.9));
  const WorldUpdate update = row.world.update();
  ASSERT_EQ(update.begun.size(), 1u);
  row.world.wake(row.world.island(update.begun[0].a));
  for (const BodyId id : row.bodies)
    EXPECT_TRUE(row.world.is_awake(id));
  Bodies stale = row.bodies;
  ++stale[3].generation;
  try {
    row.world.sleep(stale);
    ADD_FAILURE();
  } catch (const StaleIdError& error) {
    EXPECT_EQ(std::string(error.what()).find("sleep, element 3: "), 0u) << error.what();
    EXPECT_EQ(error.place().index, 3u);
  }
  EXPECT_TRUE(row.world.is_awake(row.bodies[0])) << "all or none";
  EXPECT_THROW(row.world.wake(stale), StaleIdError);
}

TEST(WorldIslands, ABodyThatTakesTheIndexOfAnotherIsInNoneUntilAnUpdate) {
  World world({.threads = 1, .islands = true});
  const BodyId a = world.add({kBall, at(0)});
  const BodyId b = world.add({kBall, at(0.5)});
  world.update();
  EXPECT_EQ(world.islands(), (BodySets{{a, b}}));
  world.remove(a);
  EXPECT_EQ(world.islands(), (BodySets{{b}}));
  BodyId c = a;
  for (int n = 0; n < 8 && (n == 0 || c.index != a.index); ++n) {
    if (n > 0) world.remove(c);
    world.update();
    world.update();
    c = world.add({kBall, at(9)});
  }
  ASSERT_EQ(c.index, a.index) << "the index is used again";
  EXPECT_EQ(world.islands(), (BodySets{{b}}));
  EXPECT_TRUE(world.island(c).empty());
  world.update();
  EXPECT_EQ(world.islands(), islands_from_scratch(world));
  EXPECT_EQ(world.island(c), Bodies{c});
}

TEST(WorldIds, ThoseOfAnotherWorldAreRefused) {
  World one({.number = 1}), other({.number = 2}), without;
  const BodyId in_one = one.add({kBall, at(0)}), in_other = other.add({kBall, at(7)});
  const BodyId in_none = without.add({kBall, at(9)});
  EXPECT_NE(in_one, in_other);
  EXPECT_NE(std::hash<BodyId>()(in_one), std::hash<BodyId>()(in_other));
  EXPECT_FALSE(one.contains(in_other) || without.contains(in_other) || one.contains(in_none));
  EXPECT_THROW(World({.number = 256}), InputError);
  EXPECT_THROW(one.move(in_other, at(1)), StaleIdError);
  EXPECT_THROW(other.pairs(in_one), StaleIdError);
  try {
    one.pose(in_other);
    ADD_FAILURE();
  } catch (const StaleIdError& error) {
    EXPECT_NE(std::string(error.what()).find("of another world"), std::string::npos);
  }
  one.update();
  other.restore(one.snapshot());
  EXPECT_TRUE(other.contains(in_one)) << "a restored world is the one that it is a copy of";
  EXPECT_FALSE(other.contains(in_other));
  const World moved = std::move(one);
  EXPECT_TRUE(moved.contains(in_one));
  EXPECT_EQ(moved.bodies(), Bodies{in_one});
}

}  // namespace
}  // namespace graze
