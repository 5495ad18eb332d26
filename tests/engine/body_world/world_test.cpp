#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "tests/engine/broad_phase/box_histories.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using test::Chance;

/// A ball, by the definition: its box is larger than itself, so that candidates need not touch.
class Ball : public BodyShape {
 public:
  explicit Ball(double radius) : radius_(radius) {}
  Aabb bounds(const Pose& pose) const override {
    const Eigen::Vector3d centre = pose.translation(), reach = Eigen::Vector3d::Constant(radius_);
    return {centre - reach, centre + reach};
  }
  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    const double reach = radius_ + static_cast<const Ball&>(other).radius_;
    const Eigen::Vector3d way = pose.translation() - other_pose.translation();
    return way.squaredNorm() <= reach * reach;
  }

 private:
  double radius_;
};

using tests::at;

std::vector<BodyPair> list(std::span<const BodyPair> pairs) {
  return {pairs.begin(), pairs.end()};
}

std::vector<BodyPair> difference(const std::vector<BodyPair>& left,
                                 const std::vector<BodyPair>& right) {
  std::vector<BodyPair> rest;
  std::set_difference(left.begin(), left.end(), right.begin(), right.end(),
                      std::back_inserter(rest));
  return rest;
}

/// A world and what it should say, by testing all bodies with all.
class WorldHistory {
 public:
  explicit WorldHistory(std::uint64_t seed) : chance_(seed) {
    for (const double radius : {0.2, 0.5, 1.0, 3.0})
      balls_.push_back(std::make_shared<Ball>(radius));
  }

  void change() {
    const std::uint32_t what = chance_.below(20);
    if (bodies_.size() < 3 || (what < 3 && bodies_.size() < 80)) {
      Body body{balls_[chance_.below(4)],
                random_pose(),
                {random_motion(), random_filter(), chance_.bits()},
                true};
      const BodyId id = world_.add({body.ball, body.pose}, body.settings);
      bodies_[id] = body;
      touched_.insert(id);
      changed_.insert(id);
    } else if (what == 3) {
      const BodyId id = pick();
      world_.remove(id);
      bodies_.erase(id);
      std::erase_if(excluded_, [&](const BodyPair& pair) { return pair.a == id || pair.b == id; });
      EXPECT_THROW(world_.remove(id), StaleIdError);
    } else if (what == 4) {
      const BodyId id = pick();
      bodies_[id].settings.filter = random_filter();
      changed_.insert(id);
      world_.set_filter(id, bodies_[id].settings.filter);
    } else if (what == 5) {
      const BodyId id = pick();
      bodies_[id].settings.kind = random_motion();
      changed_.insert(id);
      world_.set_kind(id, bodies_[id].settings.kind);
    } else if (what == 6) {
      exclude_or_include();
    } else if (what == 7) {
      sleep(pick());
    } else if (what == 8) {
      const BodyId id = pick();
      if (!bodies_[id].is_awake) changed_.insert(id), touched_.insert(id);
      bodies_[id].is_awake = true;
      world_.wake(id);
    } else {
      const BodyId id = pick();
      bodies_[id].pose = random_pose();
      bodies_[id].is_awake = true;
      world_.move(id, bodies_[id].pose);
      touched_.insert(id);
      changed_.insert(id);
      EXPECT_EQ(world_.is_awake(id), bodies_[id].settings.kind != BodyKind::Static);
      if (chance_.one_in(6)) sleep(id);
    }
  }

  void check() {
    const std::vector<BodyPair> now = pairs();
    const WorldUpdate update = world_.update();
    ASSERT_EQ(list(update.begun), difference(now, before_));
    ASSERT_EQ(list(update.ended), difference(before_, now));
    for (const BodyPair& pair : update.moved)
      ASSERT_TRUE(std::binary_search(now.begin(), now.end(), pair));
    for (const BodyPair& pair : now) {
      const bool is_listed = std::binary_search(update.moved.begin(), update.moved.end(), pair);
      if (!is_looked_at(pair)) {
        ASSERT_FALSE(is_listed);
        continue;
      }
      if (touched_.contains(pair.a) || touched_.contains(pair.b)) {
        ASSERT_TRUE(is_listed);
      }
    }
    ASSERT_EQ(world_.pairs(), now);
    ASSERT_EQ(world_.size(), bodies_.size());
    before_ = now;
    touched_.clear();
    changed_.clear();
    slept_ += update.work.pairs_asleep;
  }

  Chance& chance() { return chance_; }
  World& world() { return world_; }
  std::uint64_t slept() const { return slept_; }

 private:
  struct Body {
    std::shared_ptr<const Ball> ball;
    Pose pose;
    BodySettings settings;
    bool is_awake = true;
  };

  void sleep(BodyId id) {
    world_.sleep(id);
    bodies_[id].is_awake = false;
    EXPECT_FALSE(world_.is_awake(id));
  }
  /// Static bodies are up only where they changed.
  bool is_looked_at(const BodyPair& pair) const {
    const auto is_up = [&](BodyId id) {
      const Body& body = bodies_.at(id);
      return body.is_awake && (changed_.contains(id) || body.settings.kind != BodyKind::Static);
    };
    return (changed_.contains(pair.a) || changed_.contains(pair.b)) &&
           (is_up(pair.a) || is_up(pair.b));
  }

  Pose random_pose() {
    Eigen::Vector3d p;
    for (int c = 0; c < 3; ++c)
      p[c] = chance_.between(-5, 5);
    return at(p[0], p[1], p[2]);
  }
  BodyKind random_motion() {
    return static_cast<BodyKind>(chance_.one_in(2) ? 2 : chance_.below(3));
  }
  Filter random_filter() {
    return {1u << chance_.below(3), chance_.one_in(2) ? ~0u : chance_.below(8),
            static_cast<std::int32_t>(chance_.below(4)) - 1};
  }
  BodyId pick() {
    auto body = bodies_.begin();
    std::advance(body, chance_.below(static_cast<std::uint32_t>(bodies_.size())));
    return body->first;
  }
  void exclude_or_include() {
    const BodyId a = pick(), b = pick();
    if (a == b) return;
    const BodyPair pair{std::min(a, b), std::max(a, b)};
    if (chance_.one_in(3)) {
      world_.include(a, b);
      if (excluded_.erase(pair) != 0) changed_.insert(a);
    } else {
      world_.exclude(a, b);
      if (excluded_.insert(pair).second) changed_.insert(a);
    }
  }
  bool meet(const BodyId& a, const Body& s, const BodyId& b, const Body& t) const {
    if (s.settings.kind != BodyKind::Dynamic && t.settings.kind != BodyKind::Dynamic) return false;
    if (!lets_pass(s.settings.filter, t.settings.filter) || excluded_.contains({a, b}))
      return false;
    if (is_looked_at({a, b})) return s.ball->touches(s.pose, *t.ball, t.pose);
    return std::binary_search(before_.begin(), before_.end(), BodyPair{a, b}) &&
           test::share_point(s.ball->bounds(s.pose), t.ball->bounds(t.pose));
  }
  std::vector<BodyPair> pairs() const {
    std::vector<BodyPair> pairs;
    for (auto s = bodies_.begin(); s != bodies_.end(); ++s) {
      for (auto t = std::next(s); t != bodies_.end(); ++t) {
        if (meet(s->first, s->second, t->first, t->second)) pairs.push_back({s->first, t->first});
      }
    }
    return pairs;
  }

  Chance chance_;
  World world_;
  std::vector<std::shared_ptr<const Ball>> balls_;
  std::map<BodyId, Body> bodies_;
  std::set<BodyPair> excluded_;
  std::set<BodyId> touched_, changed_;
  std::uint64_t slept_ = 0;
  std::vector<BodyPair> before_;
};

/// Law 9: as if all bodies were tested with all.
TEST(World, EqualsBruteForceOverRandomHistories) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WorldHistory history(seed);
    for (int operations = 0; operations < 3000;) {
      const std::uint32_t changes = history.chance().below(history.chance().one_in(10) ? 100 : 6);
      for (std::uint32_t i = 0; i < changes; ++i, ++operations)
        history.change();
      history.check();
      ++operations;
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(history.slept(), 100u);
  }
}

TEST(World, ARestoredWorldGoesOnAsTheFirstTime) {
  WorldHistory history(9);
  for (int i = 0; i < 300; ++i)
    history.change();
  history.check();
  World& world = history.world();
  const WorldSnapshot snapshot = world.snapshot();
  const auto run = [&] {
    std::vector<BodyPair> seen;
    const auto ball = std::make_shared<Ball>(2);
    std::vector<BodyId> mine;
    for (int frame = 0; frame < 20; ++frame) {
      if (frame % 3 == 0) mine.push_back(world.add({ball, at(0.4 * frame - 4, 0.1 * frame)}));
      for (const BodyId id : mine)
        world.move(id, at(5 - 0.5 * frame, 0.2 * id.index));
      if (frame == 15) world.remove(mine[2]), mine.erase(mine.begin() + 2);
      const WorldUpdate update = world.update();
      for (const std::span<const BodyPair> pairs : {update.begun, update.ended, update.moved})
        seen.insert(seen.end(), pairs.begin(), pairs.end());
    }
    return seen;
  };
  const std::vector<BodyPair> first = run();
  EXPECT_FALSE(first.empty());
  world.restore(snapshot);
  EXPECT_EQ(run(), first);
  world.restore(snapshot);
  EXPECT_EQ(run(), first);
  world.add({std::make_shared<Ball>(1), at(0)});
  EXPECT_THROW(world.snapshot(), InputError);
}

TEST(World, AsksTheUsersFilterLast) {
  World world;
  int asked = 0;
  world.set_pair_filter([&](BodyId, BodyId) { return ++asked, false; });
  const auto ball = std::make_shared<Ball>(1);
  const BodyId a = world.add({ball, at(0)});
  world.add({ball, at(1)});
  world.add({ball, at(0.5)}, {.kind = BodyKind::Dynamic, .filter = {.category = 2, .mask = 0}});
  EXPECT_TRUE(world.update().begun.empty());
  EXPECT_EQ(asked, 1);
  world.set_pair_filter({});
  EXPECT_EQ(world.update().begun.size(), 1u);
  EXPECT_EQ(world.find_in_box({{-1, -1, -1}, {-0.9, 1, 1}}), (std::vector<BodyId>{a}));
}

TEST(World, RefusesWhatItCannotPlace) {
  World world;
  const auto ball = std::make_shared<Ball>(1);
  EXPECT_THROW(world.add({nullptr, at(0)}), InputError);
  EXPECT_THROW(world.add({ball, at(std::numeric_limits<double>::infinity())}), PoseError);
  EXPECT_THROW(world.add({std::make_shared<Ball>(std::numeric_limits<double>::infinity()), at(0)}),
               InputError);
  EXPECT_THROW(world.set_user_data({}, 1), StaleIdError);
  EXPECT_EQ(world.size(), 0u);
}

}  // namespace
}  // namespace graze
