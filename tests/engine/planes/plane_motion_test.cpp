// Planes that are met on the way, from either side, beside the half-space behind them.

#include <graze/bvh/error.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/print.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;
using tests::random_pose;

TEST(PlaneMotions, ABallMeetsOneFromEitherSide) {
  const Shape ball = Sphere{{0, 0, 0}, 0.5};
  const Shape floor = Plane{{0, 0, 1}, 0};
  for (const double side : {1.0, -1.0}) {
    const auto met = cast(floor, {ball, at(0, 0, 2.5 * side)}, {0, 0, -4 * side});
    ASSERT_TRUE(met);
    EXPECT_NEAR(met->time, 0.5, 1e-12);
    EXPECT_LE(met->time, 0.5);
    EXPECT_EQ(met->normal, Vector3d(0, 0, side));
    EXPECT_FALSE(cast(floor, {ball, at(0, 0, 2.5 * side)}, {1, 0, 4 * side}));
    const RigidContact contact =
        first_contact({ball, RigidMotion(at(0, 0, 2.5 * side), {.shift = {0, 0, -4 * side}})},
                      {floor, RigidMotion(Pose::Identity())});
    EXPECT_EQ(contact.status, RigidStatus::Hit);
    EXPECT_LE(contact.low, 0.5);
    EXPECT_NEAR(contact.low, 0.5, 1e-6);
    EXPECT_TRUE(is_free({ball, RigidMotion(at(0, 0, 2.5 * side), {.shift = {0, 0, -1.5 * side}})},
                        {floor, RigidMotion(Pose::Identity())}));
  }
  const auto inside = cast(floor, {ball, at(0, 0, -0.25)}, {0, 0, 1});
  ASSERT_TRUE(inside);
  EXPECT_TRUE(inside->is_at_start);
  EXPECT_EQ(inside->normal, Vector3d(0, 0, -1));
}

// A door that swings about z meets a ball that stands still.
TEST(PlaneMotions, APlaneThatTurnsMeetsWhatIsBeforeIt) {
  const Shape door = Plane{{0, 1, 0}, 0};
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const RigidMotion swing(Pose::Identity(), {.angle = std::numbers::pi / 2});
  for (const double side : {1.0, -1.0}) {
    // The plane through the origin that touches the ball stands at 60 degrees, of which 90 are 1.
    const Pose pose = at(0, 2 * side, 0);
    const RigidContact contact = first_contact({door, swing}, {ball, RigidMotion(pose)});
    EXPECT_EQ(contact.status, RigidStatus::Hit);
    EXPECT_LE(contact.low, 2.0 / 3);
    EXPECT_NEAR(contact.low, 2.0 / 3, 1e-5);
  }
}

TEST(PlaneMotions, SayOfWhatIsConvexWhatTheHalfSpaceBehindSays) {
  RandomSource source(8);
  int met = 0;
  for (int n = 0; n < 1500 && !HasFailure(); ++n) {
    SCOPED_TRACE(n);
    const auto kind = static_cast<ShapeKind>(n % static_cast<int>(ShapeKind::HalfSpace));
    const Shape shape = tests::random_shape(kind, 0.5, source);
    const Shape as_shape = tests::random_shape(ShapeKind::Plane, 1, source);
    const Plane& plane = *as_shape.as<Plane>();
    const Pose pose = random_pose(2, source), of_plane = random_pose(1, source);
    const Shape front = HalfSpace{plane.normal, plane.offset};
    const Shape back = HalfSpace{-plane.normal, -plane.offset};
    const bool in_front = intersects({shape, pose}, {front, of_plane});
    if (in_front && intersects({shape, pose}, {back, of_plane})) continue;
    const Shape& behind = in_front ? back : front;
    const Vector3d way = source.vector(-3, 3);
    const auto found = cast({as_shape, of_plane}, {shape, pose}, way);
    EXPECT_EQ(found, cast({behind, of_plane}, {shape, pose}, way));
    const RigidMotion motion(pose, {.centre = pose.translation(),
                                    .shift = way,
                                    .axis = source.vector(-1, 1),
                                    .angle = source.uniform(-2, 2)});
    const RigidMotion rest(of_plane);
    const RigidContact contact = first_contact({shape, motion}, {as_shape, rest});
    EXPECT_EQ(contact, first_contact({shape, motion}, {behind, rest}));
    EXPECT_EQ(first_contact({as_shape, rest}, {shape, motion}), contact);
    met += contact.status == RigidStatus::Hit;
  }
  EXPECT_GT(met, 200);
}

TEST(PlaneMotions, OfAMeshInPiecesTheFirstPieceCounts) {
  const std::vector<Vector3d> vertices = {{0, 0, 1},  {1, 0, 1},  {0, 1, 1},
                                          {0, 0, -2}, {1, 0, -2}, {0, 1, -2}};
  const Shape pieces = Mesh(vertices, std::vector<TriangleIndices>{{0, 1, 2}, {3, 4, 5}});
  const Shape floor = Plane{{0, 0, 1}, 0};
  for (const auto& [way, wanted] : {std::pair(-4.0, 0.25), std::pair(4.0, 0.5)}) {
    SCOPED_TRACE(way);
    const auto met = cast(floor, pieces, {0, 0, way});
    ASSERT_TRUE(met);
    EXPECT_LE(met->time, wanted);
    EXPECT_NEAR(met->time, wanted, 1e-12);
    const RigidContact contact =
        first_contact({pieces, RigidMotion(Pose::Identity(), {.shift = {0, 0, way}})},
                      {floor, RigidMotion(Pose::Identity())});
    EXPECT_EQ(contact.status, RigidStatus::Hit);
    EXPECT_LE(contact.low, wanted);
    EXPECT_NEAR(contact.low, wanted, 1e-5);
    EXPECT_GE(contact.high, wanted - 1e-9);
  }
  EXPECT_FALSE(cast(floor, pieces, {0, 0, -0.5}));
  EXPECT_TRUE(is_free({pieces, RigidMotion(Pose::Identity(), {.shift = {0, 0, -0.5}})},
                      {floor, RigidMotion(Pose::Identity())}));
}

// In a step of the grid a small ball comes from one side of a plane to the other. What is said to
// be the time of a hit is one at which the two touch.
TEST(PlaneMotions, AHitIsATimeAtWhichThePlaneIsTouched) {
  const Shape floor = Plane{{0, 0, 1}, 0};
  const RigidMotion still(Pose::Identity());
  for (const double radius : {1e-90, 1e-17, 1e-9, 1e-6, 1e-4}) {
    for (const double tolerance : {1e-6, 1e-3}) {
      for (const double clearance : {0.0, 1e-9}) {
        SCOPED_TRACE(radius);
        const Shape ball = Sphere{{0, 0, 0}, radius};
        const RigidMotion falls(at(0.1, 0.2, 1.0 / 3), {.shift = {0, 0, -1}});
        const RigidContact contact = first_contact(
            {ball, falls}, {floor, still}, {.clearance = clearance, .tolerance = tolerance});
        ASSERT_NE(contact.status, RigidStatus::Free);
        EXPECT_LE(contact.low, 1.0 / 3);
        EXPECT_TRUE(contact.status == RigidStatus::Hit || radius < 1e-9) << contact;
        if (contact.status != RigidStatus::Hit) continue;
        const Pose pose = falls.at(contact.high);
        EXPECT_LE(distance({ball, pose}, {floor}).distance, clearance);
        EXPECT_TRUE(clearance > 0 || intersects({ball, pose}, {floor}));
      }
    }
  }
}

TEST(PlaneMotions, OfTwoThatTurnNothingIsSaid) {
  const Shape floor = Plane{{0, 0, 1}, 0};
  EXPECT_THROW(first_contact({floor, RigidMotion(Pose::Identity(), {.angle = 1})},
                             {HalfSpace{{0, 0, 1}, -1}, RigidMotion(Pose::Identity())}),
               UnsupportedPairError);
  const RigidContact contact =
      first_contact({floor, RigidMotion(Pose::Identity(), {.shift = {0, 0, -4}})},
                    {Plane{{0, 0, 1}, -1}, RigidMotion(Pose::Identity())});
  EXPECT_EQ(contact.status, RigidStatus::Hit);
  EXPECT_NEAR(contact.low, 0.25, 1e-6);
}

}  // namespace
}  // namespace graze
