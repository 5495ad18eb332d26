// Contacts that go on keep their numbers, others get new ones: law 15 along motions of bodies
// all of whose points are known, and what begins, ends and stays of pairs.

#include <graze/bvh/error.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/contact_tracker.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <set>
#include <span>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using tests::at;
using Ids = std::vector<std::uint64_t>;

/// What a contact was, in an update.
struct Told {
  double depth;
  Vector3d normal;
  ContactFeature feature;
};

/// Of contacts that lasted from one update to the next, as numbers say or as features do.
struct Lasting {
  int contacts = 0, lasted = 0, jumped = 0, turned = 0;
};

/// A mesh body over a fixed one, and how far its vertices, which are its farthest points, went.
class RollingBody {
 public:
  RollingBody(const Mesh& ground, const Mesh& body, RandomSource& source)
      : vertices_(body.vertices().begin(), body.vertices().end()),
        size_(std::min(size_of(ground), size_of(body))) {
    ground_ = world_.add({ground}, {.kind = BodyKind::Static});
    const double angle = source.uniform(-3, 3);
    pose_.linear() = AngleAxisd(angle, source.vector(-1, 1).normalized()).toRotationMatrix();
    const double below = tests::reach_of(body, pose_, {0, 0, -1});
    pose_.translation() = source.vector(-0.1, 0.1);
    pose_.translation().z() =
        tests::reach_of(ground, Pose::Identity(), {0, 0, 1}) + below - 0.01 * size_;
    body_ = world_.add({body, pose_});
  }

  void step(double share, RandomSource& source) {
    Pose next = pose_;
    const double angle = share * source.uniform(0, 1);
    next.linear() = AngleAxisd(angle, source.vector(-1, 1).normalized()) * pose_.linear();
    next.translation() += share * size_ * 0.3 * source.vector(-1, 1);
    next.translation().z() = pose_.translation().z();
    double moved = 0;
    for (const Vector3d& vertex : vertices_)
      moved = std::max(moved, (next * vertex - pose_ * vertex).norm());
    pose_ = next;
    world_.move(body_, pose_);
    take(moved);
  }

  const Lasting& by_ids() const { return by_ids_; }
  const Lasting& by_features() const { return by_features_; }

 private:
  static double size_of(const Mesh& mesh) { return (mesh.bounds().max - mesh.bounds().min).norm(); }

  void take(double moved) {
    const WorldUpdate update = world_.update();
    tracker_.take(world_, update);
    std::map<std::uint64_t, Told> told;
    for (std::size_t i = 0; i < update.contacts.size(); ++i) {
      const std::span<const std::uint64_t> ids = tracker_.ids(i);
      const Manifold& manifold = update.contacts[i].manifold;
      ASSERT_EQ(ids.size(), manifold.size());
      for (std::size_t k = 0; k < ids.size(); ++k) {
        const Told now{manifold[k].depth, manifold[k].normal, manifold[k].feature};
        ASSERT_TRUE(told.emplace(ids[k], now).second) << "one number, two contacts";
        const bool was_there = last_.contains(ids[k]);
        EXPECT_TRUE(was_there || ids[k] > highest_) << "a number that had been given";
        count(now, was_there ? &last_.at(ids[k]) : nullptr, moved, by_ids_);
        const auto same = std::ranges::find_if(
            last_, [&](const auto& old) { return old.second.feature == now.feature; });
        count(now, same == last_.end() ? nullptr : &same->second, moved, by_features_);
      }
    }
    for (const auto& [id, contact] : told)
      highest_ = std::max(highest_, id);
    last_ = std::move(told);
  }

  void count(const Told& now, const Told* before, double moved, Lasting& kept) const {
    ++kept.contacts;
    if (before == nullptr) return;
    ++kept.lasted;
    kept.jumped += std::abs(now.depth - before->depth) > 2 * moved + 1e-6 * size_;
    kept.turned +=
        moved <= 1e-4 * size_ && now.normal.dot(before->normal) < std::cos(std::numbers::pi / 180);
  }

  World world_;
  ContactTracker tracker_;
  std::vector<Vector3d> vertices_;
  double size_;
  Pose pose_ = Pose::Identity();
  BodyId ground_, body_;
  std::map<std::uint64_t, Told> last_;
  std::uint64_t highest_ = 0;
  Lasting by_ids_, by_features_;
};

void add(const Lasting& more, Lasting& to) {
  to.contacts += more.contacts;
  to.lasted += more.lasted;
  to.jumped += more.jumped;
  to.turned += more.turned;
}

// Features of the same contacts break the law on these paths, so that they would show numbers that
// do.
TEST(ContactTracker, Law15WhatLastsChangesAsItMoves) {
  RandomSource source(1571);
  Lasting by_ids, by_features;
  for (int n = 0; n < 48; ++n) {
    const Mesh ground = tests::convex_mesh(tests::kConvexMeshKinds[n % 4], 1 + n % 3, source);
    const Mesh body = tests::convex_mesh(tests::kConvexMeshKinds[n / 4 % 4], 2, source);
    RollingBody rolling(ground, body, source);
    for (int step = 0; step < 60; ++step) {
      const double share = std::pow(10, source.uniform(-6, -2));
      ASSERT_NO_FATAL_FAILURE(rolling.step(share, source)) << "pair " << n << ", step " << step;
    }
    add(rolling.by_ids(), by_ids);
    add(rolling.by_features(), by_features);
  }
  EXPECT_GT(by_ids.contacts, 2000);
  EXPECT_GT(by_ids.lasted, 0.9 * by_ids.contacts);
  EXPECT_EQ(by_ids.jumped, 0);
  EXPECT_EQ(by_ids.turned, 0);
  EXPECT_GT(by_features.jumped + by_features.turned, 0);
}

/// A world of one pair, and its numbers as last told.
struct Tracked {
  explicit Tracked(const WorldSettings& settings = {}) : world(settings) {}

  void update() {
    const WorldUpdate news = world.update();
    tracker.take(world, news);
    ids.clear();
    for (std::size_t i = 0; i < news.contacts.size(); ++i)
      ids.emplace_back(tracker.ids(i).begin(), tracker.ids(i).end());
  }

  World world;
  ContactTracker tracker;
  std::vector<Ids> ids;  ///< of each manifold
};

const Shape kCube = Box{{0.5, 0.5, 0.5}};

TEST(ContactTracker, ABoxThatSlidesKeepsItsFourAndOnItsOtherSideHasOthers) {
  Tracked scene;
  scene.world.add({HalfSpace{{0, 0, 1}}}, {.kind = BodyKind::Static});
  const BodyId box = scene.world.add({kCube, at(0, 0, 0.499)});
  scene.update();
  ASSERT_EQ(scene.ids.size(), 1u);
  const Ids first = scene.ids[0];
  ASSERT_EQ(first.size(), 4u);
  EXPECT_EQ(std::set<std::uint64_t>(first.begin(), first.end()).size(), 4u);
  EXPECT_GT(std::ranges::min(first), 0u);
  for (int step = 1; step <= 20; ++step) {
    scene.world.move(box, at(0.1 * step, 0, 0.499));
    scene.update();
    ASSERT_EQ(scene.ids[0], first) << "step " << step;
  }
  Pose upside_down = at(7, 0, 0.499);
  upside_down.linear() = AngleAxisd(std::numbers::pi, Vector3d::UnitX()).toRotationMatrix();
  scene.world.move(box, upside_down);
  scene.update();
  for (const std::uint64_t id : scene.ids[0])
    EXPECT_GT(id, std::ranges::max(first));
}

TEST(ContactTracker, WhatStaysAtItsPlaceGoesOnThoughOtherPartsMeet) {
  Tracked scene;
  scene.world.add({HalfSpace{{0, 0, 1}}}, {.kind = BodyKind::Static});
  const BodyId box = scene.world.add({kCube, at(0, 0, 0.499)});
  scene.update();
  const Ids first = scene.ids[0];
  Pose upside_down = at(0, 0, 0.499);  // on its upper face, at the same place of the ground
  upside_down.linear() = AngleAxisd(std::numbers::pi, Vector3d::UnitX()).toRotationMatrix();
  scene.world.move(box, upside_down);
  scene.update();
  EXPECT_TRUE(std::ranges::is_permutation(scene.ids[0], first));
}

TEST(ContactTracker, WhatPartsAndMeetsAgainIsNew) {
  Tracked scene;
  scene.world.add({kCube}, {.kind = BodyKind::Static});
  const BodyId ball = scene.world.add({Sphere{{0, 0, 0}, 0.5}, at(0, 0, 0.999)});
  scene.update();
  const std::vector<Ids> first = scene.ids;
  scene.update();  // nothing moved: nothing is listed, and all is known
  EXPECT_TRUE(scene.ids.empty());
  EXPECT_EQ(scene.tracker.size(), 1u);
  scene.world.move(ball, at(0, 0, 0.9985));
  scene.update();
  EXPECT_EQ(scene.ids, first);
  scene.world.move(ball, at(0, 0, 1.01));
  scene.update();
  EXPECT_EQ(scene.tracker.size(), 0u);
  scene.world.move(ball, at(0, 0, 0.9985));
  scene.update();
  ASSERT_EQ(scene.ids.size(), 1u);
  EXPECT_NE(scene.ids, first);
  scene.world.remove(ball);
  scene.update();
  EXPECT_EQ(scene.tracker.size(), 0u);
}

TEST(ContactTracker, WithinAMarginContactsGoOnThoughTheTouchEnds) {
  Tracked scene;
  scene.world.add({kCube}, {.kind = BodyKind::Static});
  const BodyId ball = scene.world.add({Sphere{{0, 0, 0}, 0.5}, at(0, 0, 0.999)}, {.margin = 0.1});
  scene.update();
  const std::vector<Ids> first = scene.ids;
  for (const double height : {1.01, 1.05, 0.999, 1.05}) {
    scene.world.move(ball, at(0, 0, height));
    scene.update();
    EXPECT_EQ(scene.ids, first) << height;
  }
  scene.world.move(ball, at(0, 0, 1.2));
  scene.update();
  EXPECT_EQ(scene.tracker.size(), 0u);
}

TEST(ContactTracker, PartsOfACompoundAreTrackedOneByOne) {
  Tracked scene;
  Compound legs;
  for (const double x : {-1.0, 0.0, 1.0})
    legs.add({Sphere{{0, 0, 0}, 0.25}, at(x, 0, 0)});
  scene.world.add({HalfSpace{{0, 0, 1}}}, {.kind = BodyKind::Static});
  const BodyId table = scene.world.add(PlacedBodyShape{share(legs), at(0, 0, 0.249)});
  scene.update();
  ASSERT_EQ(scene.ids.size(), 3u);
  const std::vector<Ids> first = scene.ids;
  Pose tilted = at(0, 0, 0.249);  // one leg is lifted, and the numbers of the others stay
  tilted.linear() = AngleAxisd(0.002, Vector3d::UnitY()).toRotationMatrix();
  scene.world.move(table, tilted);
  scene.update();
  EXPECT_EQ(scene.ids, std::vector<Ids>(first.begin() + 1, first.end()));
  scene.world.move(table, at(0, 0, 0.249));
  scene.update();
  ASSERT_EQ(scene.ids.size(), 3u);
  EXPECT_NE(scene.ids[0], first[0]);
  EXPECT_EQ(scene.ids[1], first[1]);
  EXPECT_EQ(scene.ids[2], first[2]);
}

// What ended of one pair once stood for what begins of the next, whose bodies share its shapes.
TEST(ContactTracker, NoPairTakesNumbersOfAnother) {
  Tracked scene;
  Compound legs;
  for (const double x : {-1.0, 0.0, 1.0})
    legs.add({Sphere{{0, 0, 0}, 0.25}, at(x, 0, 0)});
  const std::shared_ptr<const BodyShape> shape = share(legs);
  scene.world.add({HalfSpace{{0, 0, 1}}}, {.kind = BodyKind::Static});
  std::vector<BodyId> tables;
  for (const double y : {0.0, 1.0})
    tables.push_back(scene.world.add(PlacedBodyShape{shape, at(0, y, 0.249)}));
  const auto tilt = [&](BodyId table, double y, double angle) {
    Pose pose = at(0, y, 0.249);
    pose.linear() = AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
    scene.world.move(table, pose);
  };
  tilt(tables[1], 1, 0.002);  // its first leg is in the air
  scene.update();
  ASSERT_EQ(scene.ids.size(), 5u);
  std::set<std::uint64_t> given;
  for (const Ids& each : scene.ids)
    given.insert(each.begin(), each.end());
  tilt(tables[0], 0, 0.002);  // and now that of the other is, while it comes down
  tilt(tables[1], 1, 0);
  scene.update();
  ASSERT_EQ(scene.ids.size(), 5u);
  EXPECT_FALSE(given.contains(scene.ids[2][0]));
  for (const std::size_t stays : {0, 1, 3, 4})
    EXPECT_TRUE(given.contains(scene.ids[stays][0]));
}

TEST(ContactTracker, WhatBecomesASensorIsForgotten) {
  Tracked scene;
  scene.world.add({kCube});
  const BodyId ball = scene.world.add({Sphere{{0, 0, 0}, 0.5}, at(0, 0, 0.999)});
  scene.update();
  const std::vector<Ids> first = scene.ids;
  scene.world.set_role(ball, Role::Sensor);
  scene.update();
  EXPECT_EQ(scene.tracker.size(), 0u);
  scene.world.set_role(ball, Role::Solid);
  scene.update();
  ASSERT_EQ(scene.ids.size(), 1u);
  EXPECT_NE(scene.ids, first);
}

TEST(ContactTracker, AnotherShapeOfTheSameFormHasTheSameContacts) {
  Tracked scene;
  scene.world.add({HalfSpace{{0, 0, 1}}}, {.kind = BodyKind::Static});
  const BodyId box = scene.world.add({kCube, at(0, 0, 0.499)});
  scene.update();
  const std::vector<Ids> first = scene.ids;
  scene.world.set_shape(box, kCube);
  scene.update();
  EXPECT_EQ(scene.ids, first);
  scene.tracker.clear();
  EXPECT_EQ(scene.tracker.size(), 0u);
  scene.world.move(box, at(0, 0, 0.499));
  scene.update();
  ASSERT_EQ(scene.ids.size(), 1u);
  for (const std::uint64_t id : scene.ids[0])
    EXPECT_GT(id, std::ranges::max(first[0]));
}

TEST(ContactTracker, OfBodiesThatAreGoneNothingIsKept) {
  Tracked scene;
  RandomSource source(1572);
  const Mesh solid = tests::tessellated_box({1, 1, 1}, 2);
  scene.world.add({solid}, {.kind = BodyKind::Static, .sides = MeshSides::solid()});
  for (int n = 0; n < 300; ++n) {
    const BodyId ball = scene.world.add(
        {Sphere{{0, 0, 0}, 0.1}, Pose(Eigen::Translation3d(source.vector(-0.5, 0.5)))});
    scene.update();
    ASSERT_EQ(scene.ids.size(), 1u);
    scene.world.remove(ball);
    scene.update();
  }
  EXPECT_EQ(scene.tracker.size(), 0u);
}

TEST(ContactTracker, RefusesWhatIsNone) {
  for (const double share :
       {-1e-9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(ContactTracker({.same_place = share}), InputError) << share;
  const ContactTracker tracker;
  EXPECT_EQ(tracker.size(), 0u);
  EXPECT_THROW((void)tracker.ids(0), InputError);
  EXPECT_THROW((void)tracker.ids(std::numeric_limits<std::size_t>::max()), InputError);
}

}  // namespace
}  // namespace graze
