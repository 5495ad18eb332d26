// Bodies with margins: which pairs are near, and where, beside the pair questions by brute force.

#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

struct Member {
  BodyId id;
  Shape shape;
  Pose pose;
  double margin;
};

/// Bodies of all kinds in a small room, which they crowd, every third without a margin.
class Crowd {
 public:
  Crowd(const WorldSettings& settings, std::uint64_t seed) : world_(settings), source_(seed) {
    const ShapeKind kinds[] = {ShapeKind::Sphere,    ShapeKind::Box,  ShapeKind::Capsule,
                               ShapeKind::Cylinder,  ShapeKind::Cone, ShapeKind::Ellipsoid,
                               ShapeKind::ConvexHull};
    for (int n = 0; n < 28; ++n) {
      const Shape shape = n % 8 == 7 ? Shape(tests::random_tetrahedra(6, 0.3, source_))
                                     : tests::random_shape(kinds[n % 8], 0.3, source_);
      const double margin = n % 3 == 0 ? 0 : source_.uniform(0, 0.1);
      const Pose pose = tests::random_pose(1, source_);
      members_.push_back({world_.add({shape, pose}, {.user_data = static_cast<std::uint64_t>(n),
                                                     .margin = margin}),
                          shape, pose, margin});
    }
  }

  void step() {
    for (Member& member : members_) {
      if (source_.uniform(0, 1) < 0.3) continue;
      member.pose.translation() +=
          0.03 *
          Eigen::Vector3d{source_.uniform(-1, 1), source_.uniform(-1, 1), source_.uniform(-1, 1)};
      world_.move(member.id, member.pose);
    }
    if (source_.uniform(0, 1) < 0.3) {
      Member& member = members_[static_cast<std::size_t>(source_.uniform(0, 27.9))];
      member.margin = source_.uniform(0, 1) < 0.3 ? 0 : source_.uniform(0, 0.1);
      world_.set_margin(member.id, member.margin);
    }
  }

  World& world() { return world_; }
  const std::vector<Member>& members() const { return members_; }

 private:
  World world_;
  RandomSource source_;
  std::vector<Member> members_;
};

/// Pairs that touch, and pairs with a margin that are within it, by the pair questions.
struct Truth {
  std::set<BodyPair> touching, near;
};

Truth truth_of(const Crowd& crowd) {
  Truth truth;
  const std::vector<Member>& all = crowd.members();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const Member &a = all[i], &b = all[j];
      const bool touches = intersects({a.shape, a.pose}, {b.shape, b.pose});
      const double margin = a.margin + b.margin;
      if (touches) truth.touching.insert({a.id, b.id});
      if (margin > 0 &&
          (touches || distance({a.shape, a.pose}, {b.shape, b.pose}).distance <= margin))
        truth.near.insert({a.id, b.id});
    }
  }
  return truth;
}

std::set<BodyPair> set_of(std::span<const BodyPair> pairs) {
  return {pairs.begin(), pairs.end()};
}

/// What is in the one and not in the other.
std::set<BodyPair> difference(const std::set<BodyPair>& s, const std::set<BodyPair>& t) {
  std::set<BodyPair> found;
  for (const BodyPair& pair : s) {
    if (!t.contains(pair)) found.insert(pair);
  }
  return found;
}

TEST(WorldMargins, PairsBeginAndEndAtTheMarginAndAtTheTouch) {
  Crowd crowd({}, 2001);
  Truth before;
  std::size_t near_changes = 0;
  for (int step = 0; step < 60; ++step) {
    crowd.step();
    const WorldUpdate update = crowd.world().update();
    const Truth truth = truth_of(crowd);
    ASSERT_EQ(set_of(crowd.world().pairs()), truth.touching) << step;
    ASSERT_EQ(set_of(crowd.world().near_pairs()), truth.near) << step;
    ASSERT_EQ(set_of(update.begun), difference(truth.touching, before.touching)) << step;
    ASSERT_EQ(set_of(update.ended), difference(before.touching, truth.touching)) << step;
    ASSERT_EQ(set_of(update.begun_near), difference(truth.near, before.near)) << step;
    ASSERT_EQ(set_of(update.ended_near), difference(before.near, truth.near)) << step;
    near_changes += update.begun_near.size();
    before = truth;
  }
  EXPECT_GT(near_changes, 50u);
}

TEST(WorldMargins, ContactsAreThoseOfThePair) {
  Crowd crowd({}, 2002);
  std::size_t near = 0;
  for (int step = 0; step < 20; ++step) {
    crowd.step();
    const WorldUpdate update = crowd.world().update();
    std::map<BodyId, const Member*> of;
    for (const Member& member : crowd.members())
      of[member.id] = &member;
    const Truth truth = truth_of(crowd);
    std::size_t apart = 0;
    for (const BodyContact& contact : update.contacts) {
      const Member &a = *of[contact.pair.a], &b = *of[contact.pair.b];
      ASSERT_EQ(contact.manifold, find_contacts({a.shape, a.pose}, {b.shape, b.pose},
                                                {.margin = a.margin + b.margin}));
      ASSERT_FALSE(contact.manifold.empty());
      apart += !truth.touching.contains(contact.pair);
    }
    EXPECT_EQ(update.work.pairs_near, apart);
    EXPECT_EQ(update.contacts.size(), update.moved.size() + apart);
    EXPECT_EQ(update.work.contacts_skipped, 0u);
    near += apart;
    const std::vector<BodyContact> all = crowd.world().contacts();
    ASSERT_EQ(all.size(), difference(truth.near, truth.touching).size() + truth.touching.size());
  }
  EXPECT_GT(near, 50u);
}

/// One that saves nothing says the same, and so do more threads.
TEST(WorldMarginsThreads, WhatIsLeftOutOrSharedChangesNothing) {
  Crowd plain({}, 2003);
  Crowd thorough({.skip_apart = false, .skip_at_rest = false}, 2003);
  Crowd shared({.threads = 4}, 2003);
  std::uint64_t apart = 0;
  for (int step = 0; step < 40; ++step) {
    plain.step(), thorough.step(), shared.step();
    const WorldUpdate s = plain.world().update();
    for (Crowd* other : {&thorough, &shared}) {
      const WorldUpdate t = other->world().update();
      ASSERT_EQ(set_of(s.begun_near), set_of(t.begun_near)) << step;
      ASSERT_EQ(set_of(s.ended_near), set_of(t.ended_near)) << step;
      ASSERT_TRUE(std::ranges::equal(s.contacts, t.contacts)) << step;
    }
    apart += s.work.pairs_apart;
  }
  EXPECT_GT(apart, 30u);
}

/// Boxes of bodies have room for margins; what a box or a shape meets has not.
TEST(WorldMargins, QueriesDoNotSeeThem) {
  World world;
  const BodyId id = world.add({Sphere{{0, 0, 0}, 1}}, {.margin = 0.5});
  EXPECT_TRUE(world.find_in_box({{1.2, -1, -1}, {2, 1, 1}}).empty());
  EXPECT_EQ(world.find_in_box({{0.9, -1, -1}, {2, 1, 1}}).size(), 1u);
  EXPECT_TRUE(world.find_touching({Sphere{{2.2, 0, 0}, 1}}).empty());
  EXPECT_EQ(world.margin(id), 0.5);
}

TEST(WorldMargins, SnapshotsKeepThem) {
  Crowd crowd({}, 2004);
  crowd.step();
  crowd.world().update();
  const WorldSnapshot snapshot = crowd.world().snapshot();
  const std::vector<BodyPair> near = crowd.world().near_pairs();
  const std::vector<BodyContact> contacts = crowd.world().contacts();
  EXPECT_FALSE(near.empty());
  crowd.step();
  crowd.world().update();
  crowd.world().restore(snapshot);
  EXPECT_EQ(crowd.world().near_pairs(), near);
  EXPECT_EQ(crowd.world().contacts(), contacts);
  EXPECT_TRUE(crowd.world().update().begun_near.empty());
}

TEST(WorldMargins, OfABodyThatIsGonePairsEnd) {
  World world;
  const BodyId a = world.add({Sphere{{0, 0, 0}, 1}}, {.margin = 0.2});
  const BodyId b = world.add({Sphere{{2.1, 0, 0}, 1}});
  const WorldUpdate first = world.update();
  EXPECT_TRUE(first.begun.empty());
  ASSERT_EQ(first.begun_near.size(), 1u);
  ASSERT_EQ(first.contacts.size(), 1u);
  EXPECT_NEAR(first.contacts[0].manifold[0].depth, -0.1, 1e-12);
  world.remove(b);
  const WorldUpdate second = world.update();
  EXPECT_TRUE(second.ended.empty());
  EXPECT_EQ(second.ended_near.size(), 1u);
  EXPECT_TRUE(world.contains(a));
}

TEST(WorldMargins, OnesThatAreNoneAreRefused) {
  World world;
  const BodyId id = world.add({Sphere{{0, 0, 0}, 1}});
  for (const double margin :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(world.add({Sphere{{0, 0, 0}, 1}}, {.margin = margin}), InputError);
    EXPECT_THROW(world.set_margin(id, margin), InputError);
  }
  EXPECT_EQ(world.size(), 1u);
  EXPECT_EQ(world.margin(id), 0);
}

}  // namespace
}  // namespace graze
