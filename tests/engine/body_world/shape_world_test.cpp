// A world of shapes beside all pairs asked one by one.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using tests::at;

/// A bit of a turn and a bit of a way.
Pose nudged(const Pose& pose, RandomSource& source, double step) {
  Pose next = tests::random_pose(1, source);
  Eigen::Quaterniond turn(next.linear());
  turn = Eigen::Quaterniond::Identity().slerp(step, turn) * Eigen::Quaterniond(pose.linear());
  next.linear() = turn.normalized().toRotationMatrix();
  next.translation() = pose.translation() + source.vector(-step, step);
  return next;
}

/// A shape of a user's own: a point.
class Dot : public BodyShape {
 public:
  Aabb bounds(const Pose& pose) const override { return {pose.translation(), pose.translation()}; }
  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    if (other.shape() == nullptr) return pose.translation() == other_pose.translation();
    return intersects({Sphere{{0, 0, 0}, 1e-9}, pose}, {*other.shape(), other_pose});
  }
  Manifold contacts(const Pose& pose, const BodyShape& other,
                    const Pose& other_pose) const override {
    if (other.shape() == nullptr) return {};
    return find_contacts({Sphere{{0, 0, 0}, 1e-9}, pose}, {*other.shape(), other_pose});
  }
};

struct Body {
  Shape shape;
  Pose pose;
};

void expect_equal(const Manifold& s, const Manifold& t) {
  ASSERT_EQ(s.size(), t.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_EQ(s[i].point, t[i].point);
    EXPECT_EQ(s[i].point_a, t[i].point_a);
    EXPECT_EQ(s[i].point_b, t[i].point_b);
    EXPECT_EQ(s[i].normal, t[i].normal);
    EXPECT_EQ(s[i].depth, t[i].depth);
    EXPECT_EQ(s[i].feature, t[i].feature);
  }
}

/// Bodies of all kinds in a random history, and a world that is told of it.
class ShapeHistory {
 public:
  ShapeHistory(std::uint64_t seed, const WorldSettings& settings)
      : source_(seed), world_(settings) {}

  void change() {
    const double what = source_.uniform(0, 1);
    if (bodies_.size() < 20) return add();
    const BodyId id = pick();
    if (what < 0.1 && bodies_.size() < 40) return add();
    if (what < 0.15) {
      world_.remove(id);
      bodies_.erase(id);
      return;
    }
    Pose& pose = bodies_.at(id).pose;
    pose = what < 0.3 ? tests::random_pose(2.5, source_) : nudged(pose, source_, 0.02);
    world_.move(id, pose);
    moved_.insert(id);
  }

  std::vector<BodyPair> touching() const {
    std::vector<BodyPair> pairs;
    for (auto s = bodies_.begin(); s != bodies_.end(); ++s) {
      for (auto t = std::next(s); t != bodies_.end(); ++t) {
        if (intersects({s->second.shape, s->second.pose}, {t->second.shape, t->second.pose}))
          pairs.push_back({s->first, t->first});
      }
    }
    return pairs;
  }

  /// What the narrow phase says of a pair of bodies; half-spaces have nothing to say.
  Manifold contacts(const BodyPair& pair) const {
    const Body& a = bodies_.at(pair.a);
    const Body& b = bodies_.at(pair.b);
    if (a.shape.kind() == ShapeKind::HalfSpace && b.shape.kind() == ShapeKind::HalfSpace) return {};
    return find_contacts({a.shape, a.pose}, {b.shape, b.pose});
  }

  bool has_moved(const BodyPair& pair) const {
    return moved_.contains(pair.a) || moved_.contains(pair.b);
  }
  void rest() { moved_.clear(); }

  RandomSource& source() { return source_; }
  World& world() { return world_; }
  const std::map<BodyId, Body>& bodies() const { return bodies_; }

 private:
  void add() {
    const double kind = source_.integer(0, static_cast<int>(tests::kOwnKinds.size()) - 1);
    const Shape shape =
        tests::random_shape(tests::kOwnKinds[static_cast<std::size_t>(kind)], 0.8, source_);
    const Pose pose = tests::random_pose(2.5, source_);
    const BodyId id = world_.add({shape, pose});
    bodies_.emplace(id, Body{shape, pose});
    moved_.insert(id);
  }
  BodyId pick() {
    const double count = static_cast<double>(bodies_.size());
    return std::next(bodies_.begin(), static_cast<int>(source_.uniform(0, count)))->first;
  }

  RandomSource source_;
  World world_;
  std::map<BodyId, Body> bodies_;
  std::set<BodyId> moved_;
};

/// Law 9: broad and narrow phase together are the narrow phase alone.
TEST(ShapeWorld, EqualsBruteForceOverRandomHistories) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ShapeHistory history(seed, {});
    for (int frame = 0; frame < 200; ++frame) {
      for (int i = frame == 0 ? 30 : 8; i > 0; --i)
        history.change();
      const WorldUpdate update = history.world().update();
      const std::vector<BodyPair> now = history.touching();
      ASSERT_EQ(history.world().pairs(), now);
      std::vector<BodyPair> moved;
      std::copy_if(now.begin(), now.end(), std::back_inserter(moved),
                   [&](const BodyPair& pair) { return history.has_moved(pair); });
      ASSERT_TRUE(std::equal(update.moved.begin(), update.moved.end(), moved.begin(), moved.end()));
      history.rest();
    }
    EXPECT_FALSE(history.world().pairs().empty());
  }
}

/// Law 9: what is skipped changes no answer.
TEST(ShapeWorld, SkippingGapsChangesNoAnswer) {
  ShapeHistory skipping(5, {}), testing(5, {.skip_apart = false});
  std::uint64_t skipped = 0;
  for (int frame = 0; frame < 300; ++frame) {
    for (int i = frame == 0 ? 30 : 5; i > 0; --i)
      skipping.change(), testing.change();
    const WorldUpdate s = skipping.world().update(), t = testing.world().update();
    ASSERT_TRUE(std::equal(s.begun.begin(), s.begun.end(), t.begun.begin(), t.begun.end()));
    ASSERT_TRUE(std::equal(s.ended.begin(), s.ended.end(), t.ended.begin(), t.ended.end()));
    ASSERT_TRUE(std::equal(s.moved.begin(), s.moved.end(), t.moved.begin(), t.moved.end()));
    EXPECT_EQ(s.work.shape_tests + s.work.pairs_apart, t.work.shape_tests);
    EXPECT_EQ(s.work.pairs_at_rest, t.work.pairs_at_rest);
    EXPECT_EQ(t.work.pairs_apart + t.work.gaps_measured, 0u);
    skipped += s.work.pairs_apart;
  }
  EXPECT_GT(skipped, 100u);
}

/// A long rod turns about its middle, which stays where it is, until its end meets a post.
TEST(ShapeWorld, CountsTurningAsMotion) {
  World world({.contacts = false});
  const Shape rod = Cylinder{0.1, 5}, post = Cylinder{0.2, 1};
  const BodyId turning = world.add({rod, at(0, 0, 0)});
  const Pose place = at(0, 4, 1);
  world.add({post, place}, {.kind = BodyKind::Static});
  bool has_touched = false, has_parted = false;
  std::uint64_t skipped = 0;
  for (int frame = 0; frame < 400; ++frame) {
    Pose pose = at(0, 0, 0);
    pose.rotate(Eigen::AngleAxisd(-0.006 * frame, Eigen::Vector3d::UnitX()));
    world.move(turning, pose);
    skipped += world.update().work.pairs_apart;
    const bool touches = intersects({rod, pose}, {post, place});
    ASSERT_EQ(world.pairs().size(), touches ? 1u : 0u) << frame;
    has_touched = has_touched || touches;
    has_parted = has_parted || (has_touched && !touches);
  }
  EXPECT_TRUE(has_parted);
  EXPECT_GT(skipped, 10u);
}

/// Law 9: a query of the world is one of each body.
TEST(ShapeWorld, QueriesEqualBruteForce) {
  ShapeHistory history(11, {});
  RandomSource source(12);
  std::size_t found_touching = 0, found_near = 0;
  for (int round = 0; round < 200; ++round) {
    for (int i = round == 0 ? 30 : 2; i > 0; --i)
      history.change();
    if (round % 2 == 0) history.world().update();
    const auto kind = tests::kOwnKinds[static_cast<std::size_t>(source.integer(0, 8))];
    const Shape shape = tests::random_shape(kind, round % 3 == 0 ? 0.01 : 0.5, source);
    const Pose pose = tests::random_pose(round % 5 == 0 ? 20 : 3, source);
    const double clearance = source.uniform(0, 1);
    std::vector<BodyId> touching, near;
    std::optional<BodyDistance> closest;
    for (const auto& [id, body] : history.bodies()) {
      if (intersects({shape, pose}, {body.shape, body.pose})) touching.push_back(id);
      const ShapeDistance way = distance({shape, pose}, {body.shape, body.pose});
      if (way.distance <= clearance) near.push_back(id);
      if (!closest || way.distance < closest->distance.distance) closest = BodyDistance{id, way};
    }
    EXPECT_EQ(history.world().find_touching({shape, pose}), touching);
    std::vector<BodyId> within;
    for (const BodyDistance& body : history.world().find_within({shape, pose}, clearance))
      within.push_back(body.id);
    EXPECT_EQ(within, near);
    const std::optional<BodyDistance> found = history.world().find_closest({shape, pose});
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->id, closest->id);
    EXPECT_EQ(found->distance.distance, closest->distance.distance);
    found_touching += touching.size(), found_near += near.size();
  }
  EXPECT_GT(found_touching, 100u);
  EXPECT_GT(found_near, found_touching);
}

TEST(ShapeWorld, QueriesFindFarBodiesAndFilterThem) {
  World world;
  const Shape grain = Sphere{{0, 0, 0}, 1e-6};
  EXPECT_FALSE(world.find_closest({grain, at(0, 0, 0)}).has_value());
  const BodyId far = world.add({Sphere{{0, 0, 0}, 1}, at(1e9, 0, 0)});
  const BodyId farther = world.add({Box{{1, 1, 1}}, at(0, -3e9, 0)}, {.filter = {.category = 2}});
  EXPECT_EQ(world.find_closest({grain, at(0, 0, 0)})->id, far);
  const BodyQuerySettings only_second{.filter = Filter{.mask = 2}};
  EXPECT_EQ(world.find_closest({grain, at(0, 0, 0)}, only_second)->id, farther);
  EXPECT_FALSE(world.find_closest({grain, at(0, 0, 0)}, {.filter = Filter{.mask = 4}}).has_value());
  EXPECT_TRUE(world.find_touching({grain, at(1e9, 0, 0)}, only_second).empty());
  EXPECT_EQ(world.find_within({grain, at(0, 0, 0)}, 4e9).size(), 2u);
  EXPECT_THROW(world.find_within({grain, at(0, 0, 0)}, -1), InputError);
  world.add({std::make_shared<Dot>(), at(0, 0, 0)});
  EXPECT_EQ(world.find_touching({grain, at(0, 0, 0)}).size(), 1u);
  EXPECT_THROW(world.find_closest({grain, at(0, 0, 0)}), UnsupportedPairError);
}

// A user's own shape throws where its distance is asked.
TEST(ShapeWorld, WhatBoxesSayIsFartherThanTheNearestIsNotMeasured) {
  World world;
  world.add({std::make_shared<Dot>(), at(0, 1.4, 0)});
  const Shape ball = Sphere{{0, 0, 0}, 0.5};
  EXPECT_THROW(world.find_closest({ball, at(0, 0, 0)}), UnsupportedPairError);
  const BodyId near = world.add({Box{{0.5, 0.5, 0.5}}, at(1.2, 0, 0)});
  EXPECT_EQ(world.find_closest({ball, at(0, 0, 0)})->id, near);
  world.move(near, at(2.2, 0, 0));
  EXPECT_THROW(world.find_closest({ball, at(0, 0, 0)}), UnsupportedPairError);
}

TEST(ShapeWorld, TakesShapesAsTheyAre) {
  World world;
  const BodyId floor = world.add({Box{{10, 10, 0.1}}, at(0, 0, 0)}, {.kind = BodyKind::Static});
  const BodyId ball = world.add({Sphere{{0, 0, 0}, 0.5}, at(0, 0, 0.6)});
  world.add({Capsule{0.1, 0.5}, at(0, 0, 3)});
  world.add({tests::make_torus(1, 0.4, 8, 6), at(0, 0, -5)});
  EXPECT_EQ(world.update().begun.size(), 1u);
  EXPECT_EQ(world.pairs(), (std::vector<BodyPair>{{floor, ball}}));
  world.move(ball, at(0, 0, 0.7));
  EXPECT_EQ(world.update().ended.size(), 1u);
  EXPECT_THROW(world.move(ball, at(2 * kLargestLength, 0, 0)), PoseError);
}

TEST(ShapeWorld, ListsContactsOfWhatMoved) {
  ShapeHistory history(7, {});
  for (int frame = 0; frame < 40; ++frame) {
    for (int i = frame == 0 ? 30 : 3; i > 0; --i)
      history.change();
    const WorldUpdate update = history.world().update();
    ASSERT_EQ(update.contacts.size(), update.moved.size());
    ASSERT_EQ(update.work.contacts_found, update.moved.size());
    for (std::size_t i = 0; i < update.moved.size(); ++i) {
      ASSERT_EQ(update.contacts[i].pair, update.moved[i]);
      expect_equal(update.contacts[i].manifold, history.contacts(update.moved[i]));
    }
    const std::vector<BodyPair> pairs = history.world().pairs();
    const std::vector<BodyContact> all = history.world().contacts();
    ASSERT_EQ(all.size(), pairs.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_EQ(all[i].pair, pairs[i]);
      expect_equal(all[i].manifold, history.contacts(pairs[i]));
    }
  }
  history.change();
  EXPECT_THROW(history.world().contacts(), InputError);
}

TEST(ShapeWorld, FindsNoContactsThatNobodyAsksFor) {
  World world({.contacts = false});
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  const BodyId b = world.add({Sphere{{0, 0, 0}, 1}, at(1.5, 0, 0)});
  const WorldUpdate update = world.update();
  EXPECT_EQ(update.moved.size(), 1u);
  EXPECT_TRUE(update.contacts.empty());
  EXPECT_EQ(update.work.contacts_found, 0u);
  EXPECT_EQ(update.work.contacts_skipped, 1u);
  const std::vector<BodyContact> contacts = world.contacts();
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].pair.b, b);
  EXPECT_EQ(contacts[0].manifold[0].normal, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(contacts[0].manifold[0].depth, 0.5);
}

TEST(ShapeWorld, MeetsShapesOfAUsersOwn) {
  World world;
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  world.add({std::make_shared<Dot>(), at(0.9, 0, 0)});
  world.add({std::make_shared<Dot>(), at(0.9, 0.9, 0)});
  world.add({Box{{0.1, 0.1, 0.1}}, at(0.9, 0.9, 0)});
  const WorldUpdate update = world.update();
  EXPECT_EQ(update.begun.size(), 2u);
  ASSERT_EQ(update.contacts.size(), 2u);
  EXPECT_GT(update.contacts[0].manifold[0].normal.x(), 0.99);
  EXPECT_EQ(update.contacts[1].manifold.size(), 1u);
}

/// A shape of a user's own that counts what it is asked.
class Counting : public BodyShape {
 public:
  Aabb bounds(const Pose& pose) const override {
    const Eigen::Vector3d p = pose.translation();
    return {p, p + Eigen::Vector3d::Ones()};
  }
  bool touches(const Pose&, const BodyShape&, const Pose&) const override { return ++tests > 0; }
  Manifold contacts(const Pose&, const BodyShape&, const Pose&) const override {
    ++contacts_asked;
    return {};
  }
  mutable int tests = 0;
  mutable int contacts_asked = 0;
};

TEST(ShapeWorld, AsksAPairThatTouchesOnce) {
  for (const bool is_asked_first : {true, false}) {
    World world;
    const auto counting = std::make_shared<Counting>();
    const Shape ball = Sphere{{0, 0, 0}, 0.2};
    if (is_asked_first) world.add({counting, at(0, 0, 0)});
    const BodyId id = world.add({ball, at(0.5, 0.5, 0.5)});
    if (!is_asked_first) world.add({counting, at(0, 0, 0)});
    for (int i = 1; i < 4; ++i) {
      EXPECT_EQ(world.update().contacts.size(), 1u);
      EXPECT_EQ(counting->tests, i);
      EXPECT_EQ(counting->contacts_asked, i);
      world.move(id, at(0.5, 0.5, 0.5 + 0.01 * i));
    }
  }
}

}  // namespace
}  // namespace graze
