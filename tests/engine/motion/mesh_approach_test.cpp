// When a convex shape comes to a mesh that does not turn, beside every time of the grid (law 14);
// and what it comes to that slides along the mesh.

#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;

/// A floor of `cells` by `cells` squares of a metre, with bumps, and at x = `wall` a wall.
Mesh floor_and_wall(int cells, double bump, double wall) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j)
      vertices.emplace_back(i, j - cells / 2, bump * ((i * 7 + j * 3) % 5));
  }
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  const auto first = static_cast<std::uint32_t>(vertices.size());
  for (const double y : {-5, 5}) {
    for (const double z : {-1, 3})
      vertices.emplace_back(wall, y, z);
  }
  triangles.push_back({first, first + 1, first + 2});
  triangles.push_back({first + 1, first + 3, first + 2});
  return Mesh(vertices, triangles);
}

/// The first time of the same grid at which distance() does not prove more than the limit.
double first_time_by_sampling(const Shape& shape, const RigidMotion& motion, const Shape& mesh,
                              const RigidMotion& of_mesh, double limit, double step) {
  for (int k = 0; k * step < 1; ++k) {
    const PlacedShape placed{shape, motion.at(k * step)};
    if (!(distance(placed, PlacedShape{mesh, of_mesh.at(k * step)}).lower_bound > limit))
      return k * step;
  }
  return 1;
}

TEST(Law14MeshApproach, IsTheFirstTimeOfTheGrid) {
  RandomSource source(1201);
  int met = 0, apart = 0;
  for (int n = 0; n < 120; ++n) {
    const Mesh mesh = floor_and_wall(12, n % 2 == 0 ? 0.1 : 0, 8);
    const Shape shape = tests::random_small_shape(source, n % 5);
    const Pose start = at({source.uniform(0, 6), source.uniform(-3, 3), source.uniform(0.7, 1.5)});
    const RigidMotion motion(
        start, {.centre = start.translation() + source.vector(-0.2, 0.2),
                .shift = {source.uniform(-4, 6), source.uniform(-2, 2), source.uniform(-0.6, 0.1)},
                .axis = source.vector(-1, 1),
                .angle = n % 3 == 0 ? 0 : source.uniform(-2, 2)});
    const Pose turned = tests::moved(source, Pose::Identity(), 0.2, n % 4 == 0 ? 0.3 : 0);
    const RigidMotion of_mesh(turned,
                              {.centre = {4, 0, 0},
                               .shift = n % 5 == 0 ? Vector3d(1, 0, 0.5) : Vector3d(0, 0, 0),
                               .axis = source.vector(-1, 1),
                               .angle = n % 8 == 1 ? source.uniform(-0.5, 0.5) : 0});
    const RigidContactSettings settings{.clearance = n % 7 == 0 ? 0.05 : 0, .tolerance = 0.02};
    const RigidContact found = first_contact({shape, motion}, {mesh, of_mesh}, settings);
    const RigidContact mirrored = first_contact({mesh, of_mesh}, {shape, motion}, settings);
    EXPECT_EQ(found, mirrored);
    // The grid is no finer than this: steps of less than a quarter of the tolerance, of 16 metres.
    constexpr double kStep = 1.0 / 4096;
    const double limit = settings.clearance + settings.tolerance;
    const double truth = first_time_by_sampling(shape, motion, mesh, of_mesh, limit, kStep);
    // A coarser grid has every other of these times.
    EXPECT_GE(found.low, truth) << n;
    EXPECT_LE(found.low, truth + 16 * kStep) << n;
    (found.status == RigidStatus::Free ? apart : met) += 1;
  }
  EXPECT_GT(met, 30);
  EXPECT_GT(apart, 10);
}

/// Of two convex shapes that turn, about each other too.
TEST(Law14Approach, OfConvexShapesIsTheFirstTimeOfTheGrid) {
  RandomSource source(1202);
  int met = 0, apart = 0;
  for (int n = 0; n < 150; ++n) {
    const Shape shape_a = tests::random_small_shape(source, n % 5);
    const Shape shape_b = tests::random_small_shape(source, n / 5 % 5);
    const Pose start_a = tests::random_pose(source, 0.8), start_b = tests::random_pose(source, 0.8);
    const auto motion_of = [&](const Pose& start) {
      return RigidMotion(start, {.centre = source.vector(-1, 1),
                                 .shift = source.vector(-0.6, 0.6),
                                 .axis = source.vector(-1, 1),
                                 .angle = source.uniform(-3, 3)});
    };
    const RigidMotion motion_a = motion_of(start_a), motion_b = motion_of(start_b);
    const RigidContactSettings settings{.clearance = n % 7 == 0 ? 0.05 : 0, .tolerance = 0.02};
    const RigidContact found = first_contact({shape_a, motion_a}, {shape_b, motion_b}, settings);
    EXPECT_EQ(found, first_contact({shape_b, motion_b}, {shape_a, motion_a}, settings));
    constexpr double kStep = 1.0 / 4096;
    const double truth = first_time_by_sampling(shape_a, motion_a, shape_b, motion_b,
                                                settings.clearance + settings.tolerance, kStep);
    EXPECT_GE(found.low, truth) << n;
    EXPECT_LE(found.low, truth + 16 * kStep) << n;
    (found.status == RigidStatus::Free ? apart : met) += 1;
  }
  EXPECT_GT(met, 20);
  EXPECT_GT(apart, 20);
}

/// A box on a turntable, a millimetre above it, both turning about one axis.
TEST(Law14Approach, WhatTurnsTogetherTakesFewGaps) {
  const Mesh table = tests::make_box({3, 3, 0.1});
  const Shape box = Box{{0.2, 0.2, 0.2}};
  const RigidMotion turn_table(at(0, 0, -0.1), {.angle = 1});
  const RigidMotion turn_box(at(2, 0, 0.201), {.angle = 1});
  for (const Shape& below : {Shape(table), Shape(Box{{3, 3, 0.1}})}) {
    Work work;
    EXPECT_EQ(first_contact({box, turn_box}, {below, turn_table}, {}, &work).status,
              RigidStatus::Free);
    EXPECT_LT(work.convex_tests, 200u);
  }
}

TEST(Law14MeshApproach, ALongSlideTakesFewGaps) {
  const Mesh mesh = floor_and_wall(30, 0, 25);
  const Shape ball = Sphere{{0, 0, 0}, 0.25};
  const RigidMotion slide(at(0.5, 0, 0.2501), {.shift = {30, 0, 0}});
  Work work;
  const RigidContact found =
      first_contact({ball, slide}, {mesh, RigidMotion(at(0, 0, 0))}, {}, &work);
  EXPECT_NEAR(found.low, (24.5 - 0.25) / 30, 1e-6);
  EXPECT_EQ(found.status, RigidStatus::Hit);
  EXPECT_LT(work.convex_tests, 100u);
}

TEST(Law14MeshApproach, ABudgetEndsEarly) {
  const Mesh mesh = floor_and_wall(12, 0.1, 8);
  const Shape ball = Sphere{{0, 0, 0}, 0.25};
  const RigidMotion fall(at(3.5, 0.5, 5), {.shift = {3, 0, -6}});
  const RigidMotion rest(at(0, 0, 0));
  const RigidContact whole = first_contact({ball, fall}, {mesh, rest});
  ASSERT_EQ(whole.status, RigidStatus::Hit);
  for (std::uint64_t budget = 0; budget < 4; ++budget) {
    const RigidContact cut = first_contact({ball, fall}, {mesh, rest}, {.budget = budget});
    EXPECT_TRUE(cut.is_out_of_budget);
    EXPECT_EQ(cut.status, RigidStatus::Close);
    EXPECT_LE(cut.low, whole.low);
  }
}

/// A body on the floor of a level, and where it comes to the wall of the same mesh.
struct Slide {
  Shape shape;
  double height;  ///< of its middle
  double front;   ///< how far it reaches from there
  double angle;   ///< that it turns by, about y
};

void expect_slide_to_the_wall(const Slide& slide, double bump) {
  World world;
  const BodyId level =
      world.add({floor_and_wall(20, bump, 12), Pose::Identity()}, {.kind = BodyKind::Static});
  const BodyId body =
      world.add({slide.shape, at(2.25, 0.1, slide.height)}, {.detection = Detection::Continuous});
  world.update();
  const Pose start = at(2.25, 0.1, slide.height);
  world.move(body, RigidMotion(start, {.centre = start.translation(),
                                       .shift = {16, 0, 0},
                                       .axis = {0, 1, 0},
                                       .angle = slide.angle}));
  const WorldUpdate update = world.update();
  ASSERT_EQ(update.first_contacts.size(), 2u);
  const BodyFirstContact &start_contact = update.first_contacts[0],
                         &wall = update.first_contacts[1];
  EXPECT_EQ(start_contact.pair, (BodyPair{level, body}));
  EXPECT_TRUE(start_contact.is_at_start);
  EXPECT_EQ(start_contact.contact.low, 0);
  EXPECT_GT(start_contact.normal.z(), 0.9);
  EXPECT_EQ(wall.pair, (BodyPair{level, body}));
  EXPECT_FALSE(wall.is_at_start);
  EXPECT_EQ(wall.contact.status, RigidStatus::Hit);
  const double time = (12 - 2.25 - slide.front) / 16;
  EXPECT_LE(wall.contact.low, time);
  EXPECT_NEAR(wall.contact.low, time, 1e-6);
  EXPECT_NEAR((wall.normal - Vector3d(-1, 0, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR(wall.point.x(), 12, 1e-5);
}

TEST(SlidingBody, IsToldOfTheWallOfTheSameMesh) {
  expect_slide_to_the_wall({Sphere{{0, 0, 0}, 0.25}, 0.25, 0.25, 0}, 0);
  expect_slide_to_the_wall({Box{{0.25, 0.25, 0.25}}, 0.25, 0.25, 0}, 0);
  expect_slide_to_the_wall({Cylinder{0.25, 0.5}, 0.5, 0.25, 0}, 0);
  // Two millimetres deep, and a ball that rolls.
  expect_slide_to_the_wall({Box{{0.25, 0.25, 0.25}}, 0.248, 0.25, 0}, 0);
  expect_slide_to_the_wall({Sphere{{0, 0, 0}, 0.25}, 0.249, 0.25, 64}, 0);
}

/// Half a micrometre above the floor it does not touch that, and is told of the wall as well.
TEST(SlidingBody, IsToldOfTheWallWhereItHardlyHovers) {
  World world;
  world.add({floor_and_wall(20, 0, 12), Pose::Identity()}, {.kind = BodyKind::Static});
  const BodyId box = world.add({Box{{0.25, 0.25, 0.25}}, at(2.25, 0.1, 0.2500005)},
                               {.detection = Detection::Continuous});
  world.update();
  world.move(box, at(18.25, 0.1, 0.2500005));
  const WorldUpdate update = world.update();
  ASSERT_EQ(update.first_contacts.size(), 2u);
  EXPECT_FALSE(update.first_contacts[0].is_at_start);
  EXPECT_EQ(update.first_contacts[0].contact.low, 0);
  EXPECT_NEAR(update.first_contacts[1].contact.low, 9.5 / 16, 1e-6);
}

TEST(SlidingBody, IsToldOfNothingElse) {
  World world;
  world.add({floor_and_wall(20, 0, 12), Pose::Identity()}, {.kind = BodyKind::Static});
  const BodyId box =
      world.add({Box{{0.25, 0.25, 0.25}}, at(2, 0, 0.25)}, {.detection = Detection::Continuous});
  world.update();
  world.move(box, at(11, 0.5, 0.2495));  // short of the wall, and half a millimetre deeper
  WorldUpdate update = world.update();
  ASSERT_EQ(update.first_contacts.size(), 1u);
  EXPECT_TRUE(update.first_contacts[0].is_at_start);
  world.move(box, at(2, 0.5, 5));  // up and away
  EXPECT_EQ(world.update().first_contacts.size(), 1u);
  world.move(box, at(11, 0.5, 4));  // through nothing
  EXPECT_TRUE(world.update().first_contacts.empty());
  world.move(box, at(16, 0.5, 4));  // over the wall
  EXPECT_TRUE(world.update().first_contacts.empty());
}

/// Over bumps: what it rolls up is met, as it gets deeper behind that than it was.
TEST(SlidingBody, IsToldOfASlope) {
  World world;
  world.add({floor_and_wall(20, 0.2, 12), Pose::Identity()}, {.kind = BodyKind::Static});
  const BodyId ball =
      world.add({Sphere{{0, 0, 0}, 0.25}, at(5, 0, 0.2)}, {.detection = Detection::Continuous});
  world.update();
  world.move(ball, at(9, 0, 0.2));
  const WorldUpdate update = world.update();
  ASSERT_FALSE(update.first_contacts.empty());
  EXPECT_GT(update.first_contacts.back().contact.low, 0);
  EXPECT_LT(update.first_contacts.back().contact.low, 0.5);
}

TEST(SlidingBody, DepthThatIsNoneIsRefused) {
  EXPECT_THROW(World({.sliding_depth = -1}), InputError);
  EXPECT_THROW(World({.sliding_depth = std::nan("")}), InputError);
}

}  // namespace
}  // namespace graze
