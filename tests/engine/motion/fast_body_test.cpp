// What a world says of bodies that it sweeps, where the truth is known by formula (law 14).

#include <graze/bvh/error.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "tests/engine/body_world/users_ball.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;

constexpr BodySettings kSwept{.detection = Detection::Continuous};
const Shape kBullet = Sphere{{0, 0, 0}, 0.001};

/// The only first contact of an update.
BodyFirstContact the_only(const WorldUpdate& update) {
  if (update.first_contacts.size() != 1) throw std::logic_error("not one first contact");
  return update.first_contacts[0];
}

TEST(FastBody, DoesNotTunnelThroughAWallOfAMicrometre) {
  for (const Shape& wall : {Shape(Box{{1e-6, 10, 10}}), Shape(tests::make_box({1e-6, 10, 10}))}) {
    World world;
    const BodyId bullet = world.add({kBullet, at(-100, 0, 0)}, kSwept);
    const BodyId target = world.add({wall, at(5, 0, 0)}, {.kind = BodyKind::Static});
    EXPECT_TRUE(world.update().first_contacts.empty());
    world.move(bullet, at(900, 0, 0));
    const WorldUpdate update = world.update();
    EXPECT_TRUE(update.begun.empty());
    const BodyFirstContact met = the_only(update);
    EXPECT_EQ(met.pair, (BodyPair{bullet, target}));
    EXPECT_EQ(met.contact.status, RigidStatus::Hit);
    EXPECT_FALSE(met.is_at_start);
    const double time = (105 - 1e-6 - 0.001) / 1000;
    EXPECT_LE(met.contact.low, time);
    EXPECT_NEAR(met.contact.low, time, 1e-8);
    EXPECT_NEAR((met.normal - Vector3d(1, 0, 0)).norm(), 0, 1e-6);
    EXPECT_NEAR((met.point - Vector3d(5 - 1e-6, 0, 0)).norm(), 0, 1e-5);
    // It rests where it is: nothing to sweep.
    EXPECT_TRUE(world.update().first_contacts.empty());
    EXPECT_EQ(world.update().work.pairs_swept, 0u);
  }
}

TEST(FastBody, IsNotLookedForWhereNoneIsSwept) {
  World world;
  const BodyId bullet = world.add({kBullet, at(-100, 0, 0)});
  world.add({Box{{1e-6, 10, 10}}, at(5, 0, 0)});
  world.update();
  world.move(bullet, at(900, 0, 0));
  const WorldUpdate update = world.update();
  EXPECT_TRUE(update.first_contacts.empty());
  EXPECT_EQ(update.work.pairs_swept, 0u);
}

TEST(FastBody, SlidesOnAFloorToTheWall) {
  World world;
  const BodyId floor =
      world.add({HalfSpace{{0, 0, 1}, 0}, Pose::Identity()}, {.kind = BodyKind::Static});
  const BodyId box = world.add({Box{{0.5, 0.5, 0.5}}, at(0, 0, 0.5)}, kSwept);
  const BodyId wall = world.add({Box{{0.01, 5, 5}}, at(10, 0, 0)}, {.kind = BodyKind::Static});
  world.update();
  world.move(box, at(20, 0, 0.5));
  const WorldUpdate update = world.update();
  ASSERT_EQ(update.first_contacts.size(), 2u);
  EXPECT_EQ(update.first_contacts[0].pair, (BodyPair{floor, box}));
  EXPECT_TRUE(update.first_contacts[0].is_at_start);
  EXPECT_EQ(update.first_contacts[0].contact.low, 0);
  EXPECT_NEAR((update.first_contacts[0].normal - Vector3d(0, 0, 1)).norm(), 0, 1e-9);
  EXPECT_EQ(update.first_contacts[1].pair, (BodyPair{box, wall}));
  EXPECT_FALSE(update.first_contacts[1].is_at_start);
  EXPECT_NEAR(update.first_contacts[1].contact.low, 9.49 / 20, 1e-6);
}

/// Each passes where the other one was; they meet in the middle.
TEST(FastBody, TwoThatAreSweptMeetOnTheirWays) {
  World world;
  const BodyId a = world.add({Sphere{{0, 0, 0}, 0.5}, at(-10, 0, 0)}, kSwept);
  const BodyId b = world.add({Sphere{{0, 0, 0}, 0.5}, at(10, 0, 0)}, kSwept);
  world.update();
  world.move(a, at(10, 0, 0));
  world.move(b, at(-10, 0, 0));
  const BodyFirstContact met = the_only(world.update());
  EXPECT_NEAR(met.contact.low, 19.0 / 40, 1e-6);
  EXPECT_NEAR(met.point.norm(), 0, 1e-6);
  // Side by side at the same speed they never meet.
  world.move(a, at(0, 50, 0));
  world.move(b, at(2, 50, 0));
  world.set_detection(a, Detection::Continuous);
  world.set_detection(b, Detection::Continuous);
  world.update();
  world.move(a, at(0, -50, 0));
  world.move(b, at(2, -50, 0));
  EXPECT_TRUE(world.update().first_contacts.empty());
}

/// One that is not swept passes over a swept one that comes the other way, near or far.
TEST(FastBody, MeetsWhatMovesWithoutBeingSwept) {
  for (const double way : {0.5, 40.0}) {
    World world;
    const BodyId ball = world.add({Sphere{{0, 0, 0}, 0.01}, at(1, 0, 0)}, kSwept);
    const BodyId wall = world.add({Box{{0.001, 5, 5}}, at(0, 0, 0)});
    world.update();
    world.move(ball, at(1 - way / 10, 0, 0));
    world.move(wall, at(2 * way + 1, 0, 0));
    const BodyFirstContact met = the_only(world.update());
    EXPECT_EQ(met.pair, (BodyPair{ball, wall}));
    EXPECT_NEAR(met.contact.low, (1 - 0.011) / (2.1 * way + 1), 1e-6);
    EXPECT_NEAR(met.normal.x(), -1, 1e-6);
  }
}

TEST(FastBody, MeetsWhatGrowsOnceItHasMoved) {
  for (const bool is_set_first : {true, false}) {
    World world({.threads = 1});
    const BodyId rod = world.add({Shape(Sphere{{0, 0, 0}, 0.1})});
    const BodyId bullet = world.add({Shape(Sphere{{0, 0, 0}, 0.1}), tests::at(0, 4, 1)},
                                    {.detection = Detection::Continuous});
    world.update();
    const Shape long_one = Box{{5, 0.1, 0.1}};
    Pose turned = Pose::Identity();
    turned.linear() = Eigen::AngleAxisd(3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    if (is_set_first) world.set_shape(rod, long_one);
    world.move(rod, turned);
    if (!is_set_first) world.set_shape(rod, long_one);
    world.move(bullet, tests::at(0, 4, -1));
    EXPECT_EQ(world.update().first_contacts.size(), 1u) << is_set_first;
  }
}

TEST(FastBody, GoesAlongTheMotionThatItIsGiven) {
  World world;
  const BodyId rod = world.add({Capsule{0.05, 0.5}, at(0, 3, 1)}, kSwept);
  const BodyId post = world.add({Cylinder{0.1, 1}, at(3, 0, 1)}, {.kind = BodyKind::Static});
  world.update();
  const RigidMotion swing(at(0, 3, 1),
                          {.centre = {0, 0, 0}, .axis = {0, 0, -1}, .angle = std::numbers::pi});
  world.move(rod, swing);
  EXPECT_TRUE(world.pose(rod).isApprox(swing.at(1), 0));
  const BodyFirstContact met = the_only(world.update());
  EXPECT_EQ(met.pair, (BodyPair{rod, post}));
  EXPECT_NEAR(met.contact.low, 0.5 - 2 * std::asin(0.15 / 6) / std::numbers::pi, 1e-6);
  // Straight back it meets nothing; and that motion starts where it was, not where it is.
  EXPECT_THROW(world.move(rod, swing), InputError);
  world.move(rod, at(0, 3, 1));
  EXPECT_TRUE(world.update().first_contacts.empty());
  // The last move before an update counts, from where the body was at the one before.
  world.move(rod, at(100, 100, 100));
  world.move(rod, swing);
  EXPECT_EQ(the_only(world.update()), met);
}

TEST(FastBody, FiltersAndKindsHold) {
  World world;
  const BodyId bullet = world.add({kBullet, at(-10, 0, 0)}, kSwept);
  const BodyId sensor = world.add({Box{{0.01, 1, 1}}, at(-5, 0, 0)}, {.role = Role::Sensor});
  world.add({Box{{0.01, 1, 1}}, at(-4, 0, 0)}, {.filter = {.category = 2, .mask = 2}});
  const BodyId excluded = world.add({Box{{0.01, 1, 1}}, at(-3, 0, 0)});
  world.exclude(bullet, excluded);
  const BodyId refused = world.add({Box{{0.01, 1, 1}}, at(-2, 0, 0)});
  const BodyId wall = world.add({Box{{0.01, 1, 1}}, at(-1, 0, 0)}, {.kind = BodyKind::Static});
  world.set_pair_filter([&](BodyId a, BodyId b) { return a != refused && b != refused; });
  world.update();
  world.move(bullet, at(10, 0, 0));
  const WorldUpdate update = world.update();
  ASSERT_EQ(update.first_contacts.size(), 2u);
  EXPECT_EQ(update.first_contacts[0].pair, (BodyPair{bullet, sensor}));
  EXPECT_EQ(update.first_contacts[1].pair, (BodyPair{bullet, wall}));
  // Asleep where it was moved to it is not asked; a kinematic one meets no static one.
  world.move(bullet, at(-10, 0, 0));
  world.sleep(bullet);
  EXPECT_TRUE(world.update().first_contacts.empty());
  world.set_kind(bullet, BodyKind::Kinematic);
  world.update();
  world.move(bullet, at(10, 0, 0));
  EXPECT_EQ(the_only(world.update()).pair, (BodyPair{bullet, sensor}));
}

TEST(FastBody, IsSweptFromWhereItWasSetToBe) {
  World world;
  const BodyId bullet = world.add({kBullet, at(-10, 0, 0)});
  world.add({Box{{0.01, 1, 1}}, at(0, 0, 0)});
  world.update();
  world.move(bullet, at(10, 0, 0));
  world.set_detection(bullet, Detection::Continuous);
  EXPECT_EQ(world.detection(bullet), Detection::Continuous);
  EXPECT_TRUE(world.update().first_contacts.empty());
  world.move(bullet, at(-10, 0, 0));
  EXPECT_EQ(world.update().first_contacts.size(), 1u);
  world.move(bullet, at(10, 0, 0));
  world.set_detection(bullet, Detection::Discrete);
  EXPECT_TRUE(world.update().first_contacts.empty());
  world.set_detection(bullet, Detection::Continuous);
  world.move(bullet, at(-10, 0, 0));
  world.remove(bullet);
  EXPECT_TRUE(world.update().first_contacts.empty());
  // A new body, of the same index one day, has gone no way.
  for (int i = 0; i < 4; ++i) {
    const BodyId other = world.add({kBullet, at(10, 0, 0)}, kSwept);
    EXPECT_TRUE(world.update().first_contacts.empty());
    world.remove(other);
    world.update();
  }
}

TEST(FastBody, IsSweptOverAllThatAnUpdateLost) {
  World world;
  const BodyId bullet = world.add({kBullet, at(-10, 0, 0)}, kSwept);
  world.add({Box{{0.01, 1, 1}}, at(0, 0, 0)});
  world.update();
  bool does_throw = true;
  world.set_pair_filter([&](BodyId, BodyId) {
    if (does_throw) throw std::runtime_error("a filter");
    return true;
  });
  world.move(bullet, at(10, 0, 0));
  EXPECT_THROW(world.update(), std::runtime_error);
  does_throw = false;
  world.move(bullet, at(10, 1, 0));
  EXPECT_NEAR(the_only(world.update()).contact.low, (10 - 0.011) / 20, 1e-6);
}

TEST(FastBody, OfARestoredWorldIsSweptLikeTheFirst) {
  World world;
  const BodyId bullet = world.add({kBullet, at(-10, 0, 0)}, kSwept);
  world.add({Box{{0.01, 1, 1}}, at(0, 0, 0)});
  world.update();
  const WorldSnapshot snapshot = world.snapshot();
  world.move(bullet, at(10, 1, 0));
  const BodyFirstContact met = the_only(world.update());
  World other;
  other.restore(snapshot);
  EXPECT_EQ(other.detection(bullet), Detection::Continuous);
  other.move(bullet, at(10, 1, 0));
  EXPECT_EQ(the_only(other.update()), met);
}

/// A ball of a user's own that knows when it meets others.
class KnowingBall : public tests::UsersBall {
 public:
  using UsersBall::UsersBall;
  RigidContact first_contact(const RigidMotion& motion, const BodyShape& /*other*/,
                             const RigidMotion& /*other_motion*/,
                             const RigidContactSettings& /*settings*/) const override {
    return {RigidStatus::Hit, 0.25, motion.shift().x() > 0 ? 0.5 : 0.75, false};
  }
};

TEST(FastBody, UsersShapesAreUnknownUnlessTheyKnow) {
  World world;
  const BodyId bullet = world.add({kBullet, at(-10, 0, 0)}, kSwept);
  const BodyId mute = world.add({std::make_shared<tests::UsersBall>(1.0), at(0, 0, 0)});
  const BodyId knowing = world.add({std::make_shared<KnowingBall>(1.0), at(5, 0, 0)}, kSwept);
  world.update();
  world.move(bullet, at(10, 0, 0));
  world.move(knowing, at(1.5, 0, 0));
  const WorldUpdate update = world.update();
  ASSERT_EQ(update.first_contacts.size(), 3u);
  const RigidContact unknown{RigidStatus::Close, 0, 1, true};
  EXPECT_EQ(update.first_contacts[0].pair, (BodyPair{bullet, mute}));
  EXPECT_EQ(update.first_contacts[0].contact, unknown);
  EXPECT_FALSE(update.first_contacts[0].is_at_start);
  EXPECT_EQ(update.first_contacts[1].pair, (BodyPair{bullet, knowing}));
  EXPECT_EQ(update.first_contacts[1].contact.high, 0.75);
  EXPECT_EQ(update.first_contacts[1].normal, Vector3d::Zero());
  EXPECT_EQ(update.first_contacts[2].contact, unknown);
}

TEST(FastBody, BadInputIsRefused) {
  EXPECT_THROW(World({.sweeps = {.tolerance = -1}}), InputError);
  EXPECT_THROW(World({.sweeps = {.clearance = -1}}), InputError);
  World world;
  EXPECT_THROW(world.set_detection({3, 1}, Detection::Continuous), StaleIdError);
  EXPECT_THROW(world.move({3, 1}, RigidMotion(Pose::Identity())), StaleIdError);
  EXPECT_THROW(world.detection({3, 1}), StaleIdError);
}

}  // namespace
}  // namespace graze
