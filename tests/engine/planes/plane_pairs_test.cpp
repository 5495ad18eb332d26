// Planes beside convex shapes, half-spaces, planes and rays: known answers, and what the two
// half-spaces of a plane say.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/shape_separation.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;
using tests::random_pose;
using tests::random_shape;

constexpr double kLargest = std::numeric_limits<double>::max();

HalfSpace below(const Plane& plane) {
  return {plane.normal, plane.offset};
}

HalfSpace above(const Plane& plane) {
  return {-plane.normal, -plane.offset};
}

TEST(Planes, ABallIsMetFromBothSides) {
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const Shape floor = Plane{{0, 0, 1}, 0};
  struct Known {
    double height, distance, depth, side;
  };
  for (const Known& known :
       {Known{3, 2, 0, 1}, Known{1.5, 0.5, 0, 1}, Known{1, 0, 0, 1}, Known{0.25, 0, 0.75, 1},
        Known{0, 0, 1, 1}, Known{-0.25, 0, 0.75, -1}, Known{-1, 0, 0, -1}, Known{-4, 3, 0, -1}}) {
    const Pose pose = at(0.5, -2, known.height);
    SCOPED_TRACE(known.height);
    EXPECT_EQ(intersects({ball, pose}, floor), known.distance == 0);
    const ShapeDistance found = distance({ball, pose}, floor);
    EXPECT_EQ(found.distance, known.distance);
    EXPECT_EQ(found.normal, Vector3d(0, 0, -known.side));
    const ShapeSeparation apart = find_separation({ball, pose}, floor);
    EXPECT_EQ(apart.distance, known.distance - known.depth);
    const Manifold contacts = find_contacts({ball, pose}, floor);
    ASSERT_EQ(contacts.size(), known.distance == 0 ? 1u : 0u);
    if (contacts.empty()) {
      EXPECT_EQ(found.point_a, Vector3d(0.5, -2, known.height - known.side));
      EXPECT_EQ(found.point_b, Vector3d(0.5, -2, 0));
      continue;
    }
    EXPECT_EQ(contacts[0].depth, known.depth);
    EXPECT_EQ(contacts[0].normal, Vector3d(0, 0, -known.side));
    EXPECT_EQ(contacts[0].point_a, Vector3d(0.5, -2, known.height - known.side));
    EXPECT_EQ(contacts[0].point_b, Vector3d(0.5, -2, 0));
  }
}

TEST(Planes, ABoxThatStandsOnOneHasFourContactsAndOneThatHangsBelowItToo) {
  const Shape box = Box{{1, 2, 0.5}};
  const Shape wall = Plane{{0, 0, -2}, -6};  // z = 3
  for (const double side : {1.0, -1.0}) {
    const Manifold contacts = find_contacts({box, at(0, 0, 3 + 0.25 * side)}, wall);
    ASSERT_EQ(contacts.size(), 4u);
    for (const ShapeContact& contact : contacts) {
      EXPECT_EQ(contact.depth, 0.25);
      EXPECT_EQ(contact.normal, Vector3d(0, 0, -side));
      EXPECT_EQ(contact.point_a.cwiseAbs(), Vector3d(1, 2, 3 - 0.25 * side));
    }
  }
}

// A cone's middle is half way between apex and base, and not where its frame is turned about.
TEST(Planes, WhatReachesThroughLeavesWhereItHasLessToGo) {
  const Shape cone = Cone{1, 1};
  const Shape floor = Plane{{0, 0, 1}, 0};
  EXPECT_EQ(find_contacts({cone, at(0, 0, 0.125)}, floor)[0].depth, 0.875);
  EXPECT_EQ(find_contacts({cone, at(0, 0, -0.125)}, floor)[0].depth, 0.875);
  EXPECT_EQ(find_contacts({cone, at(0, 0, -0.125)}, floor)[0].normal, Vector3d(0, 0, 1));
  const Shape ball = Sphere{{0, 0, 5}, 1};  // far from the origin of its frame
  EXPECT_EQ(find_contacts({ball, at(0, 0, -5.5)}, floor)[0].normal, Vector3d(0, 0, 1));
  EXPECT_EQ(find_contacts({ball, at(0, 0, -4.5)}, floor)[0].normal, Vector3d(0, 0, -1));
}

void expect_swapped(const ShapeDistance& found, const ShapeDistance& swapped) {
  EXPECT_EQ(found.distance, swapped.distance);
  EXPECT_EQ(found.point_a, swapped.point_b);
  EXPECT_EQ(found.point_b, swapped.point_a);
  EXPECT_EQ(found.normal, -swapped.normal);
}

TEST(Planes, SayOfWhatIsConvexWhatTheirHalfSpacesSay) {
  RandomSource source(7);
  int hits = 0, apart = 0, upwards = 0;
  for (int n = 0; n < 4000 && !HasFailure(); ++n) {
    const auto kind = static_cast<ShapeKind>(n % static_cast<int>(ShapeKind::HalfSpace));
    SCOPED_TRACE(std::string(name_of(kind)) + " " + std::to_string(n));
    const Shape shape = random_shape(kind, 1, source);
    const Shape as_shape = random_shape(ShapeKind::Plane, 1, source);
    const Plane& plane = *as_shape.as<Plane>();
    const Pose pose = random_pose(n % 4 == 0 ? 4 : 0.6, source), of_plane = random_pose(1, source);
    const PlacedShapeView one{shape, pose}, other{as_shape, of_plane};
    const Shape front = below(plane), back = above(plane);
    const bool in_front = intersects(one, {front, of_plane});
    const bool in_back = intersects(one, {back, of_plane});
    ASSERT_EQ(intersects(one, other), in_front && in_back);
    ASSERT_EQ(intersects(other, one), in_front && in_back);
    const ShapeDistance to_front = distance(one, {front, of_plane});
    const ShapeDistance to_back = distance(one, {back, of_plane});
    const ShapeDistance found = distance(one, other);
    expect_swapped(found, distance(other, one));
    const Manifold contacts = find_contacts(one, other);
    if (!in_front || !in_back) {
      EXPECT_EQ(found, in_front ? to_back : to_front);
      EXPECT_TRUE(contacts.empty());
      ++apart;
      continue;
    }
    ++hits;
    EXPECT_EQ(found.distance, 0);
    const Shape point = Sphere{found.point_a, 1e-12};
    EXPECT_TRUE(intersects(point, one));
    EXPECT_TRUE(intersects(point, other));
    const Manifold of_front = find_contacts(one, {front, of_plane});
    const Manifold of_back = find_contacts(one, {back, of_plane});
    const bool is_front = contacts == of_front;
    upwards += is_front;
    EXPECT_TRUE(is_front || contacts == of_back);
    const double depth = std::min(of_front[0].depth, of_back[0].depth);
    EXPECT_NEAR(contacts[0].depth, depth, 1e-14);
    const Manifold swapped = find_contacts(other, one);
    ASSERT_EQ(swapped.size(), contacts.size());
    EXPECT_EQ(swapped[0].normal, -contacts[0].normal);
    EXPECT_EQ(swapped[0].point_a, contacts[0].point_b);
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(apart, 1000);
  EXPECT_GT(upwards, hits / 3);
  EXPECT_LT(upwards, 2 * hits / 3);
}

TEST(Planes, WithAMarginAreNearOnBothSides) {
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const Shape floor = Plane{{0, 0, 1}, 0};
  for (const double side : {1.0, -1.0}) {
    const Manifold near = find_contacts({ball, at(0, 0, 1.25 * side)}, floor, {.margin = 0.5});
    ASSERT_EQ(near.size(), 1u);
    EXPECT_EQ(near[0].depth, -0.25);
    EXPECT_EQ(near[0].normal, Vector3d(0, 0, -side));
    EXPECT_TRUE(find_contacts({ball, at(0, 0, 2 * side)}, floor, {.margin = 0.5}).empty());
  }
}

TEST(Planes, TwoAreApartOnlyIfTheyAreParallelAndNotOne) {
  const Shape floor = Plane{{0, 0, 1}, 1};
  const auto gap = [&](const Shape& other) {
    const double found = distance(floor, other).distance;
    EXPECT_EQ(distance(other, floor).distance, found);
    EXPECT_EQ(intersects(floor, other), found == 0);
    EXPECT_EQ(intersects(other, floor), found == 0);
    const ShapeDistance swapped = distance(other, floor);
    if (found == 0) {
      const Shape point = Sphere{swapped.point_a, 1e-12};
      EXPECT_TRUE(intersects(point, floor));
      EXPECT_TRUE(intersects(point, other));
    }
    return found;
  };
  EXPECT_EQ(gap(Plane{{0, 0, 1}, 1}), 0);
  EXPECT_EQ(gap(Plane{{0, 0, -1}, -1}), 0);
  EXPECT_EQ(gap(Plane{{0, 0, 1}, 3}), 2);
  EXPECT_EQ(gap(Plane{{0, 0, -1}, 2}), 3);
  EXPECT_EQ(gap(Plane{{0, 1, 8}, 100}), 0);
  EXPECT_EQ(gap(HalfSpace{{0, 0, 1}, 0}), 1);
  EXPECT_EQ(gap(HalfSpace{{0, 0, 1}, 1}), 0);
  EXPECT_EQ(gap(HalfSpace{{0, 0, 1}, 2}), 0);
  EXPECT_EQ(gap(HalfSpace{{0, 0, -1}, -1}), 0);
  EXPECT_EQ(gap(HalfSpace{{0, 0, -1}, -4}), 3);
  EXPECT_EQ(gap(HalfSpace{{1, 0, 0}, -4}), 0);
  EXPECT_THROW(find_contacts(floor, Shape(Plane{{1, 0, 0}, 0})), UnsupportedPairError);
}

TEST(Planes, ARayMeetsOneFromTheSideItComesFrom) {
  const Shape wall = Plane{{2, 0, 0}, 2};  // x = 1
  const Pose turned = Pose(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()));
  const auto hit = cast_ray(wall, {{4, 1, 1}, {-1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->distance, 3);
  EXPECT_EQ(hit->point, Vector3d(1, 1, 1));
  EXPECT_EQ(hit->normal, Vector3d(1, 0, 0));
  const auto behind = cast_ray(wall, {{-1, 0, 0}, {3, 4, 0}});
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->distance, 10.0 / 3, 1e-15);
  EXPECT_EQ(behind->normal, Vector3d(-1, 0, 0));
  EXPECT_FALSE(cast_ray(wall, {{4, 1, 1}, {1, 0, 0}}));
  EXPECT_FALSE(cast_ray(wall, {{-4, 1, 1}, {-1, 0, 0}}));
  EXPECT_FALSE(cast_ray(wall, {{4, 1, 1}, {0, 1, 0}}));
  EXPECT_FALSE(cast_ray(wall, {{4, 1, 1}, {-1, 0, 0}, 2.5}));
  const auto on = cast_ray(wall, {{1, 5, 5}, {0, 0, 1}});
  ASSERT_TRUE(on);
  EXPECT_EQ(on->distance, 0);
  EXPECT_EQ(on->normal, Vector3d(0, 0, -1));
  const auto up = cast_ray({wall, turned}, {{0, -3, 0}, {0, 1, 0}});
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->distance, 4, 1e-15);
}

TEST(Planes, HaveThinBoxesAlongAxes) {
  const Aabb flat = bounding_aabb({Plane{{0, -3, 0}, 6}, at(7, 5, 0)});  // y = 3
  EXPECT_LE(flat.min.y(), 3);
  EXPECT_GE(flat.max.y(), 3);
  EXPECT_LT(flat.max.y() - flat.min.y(), 1e-12);
  EXPECT_EQ(flat.min.x(), -kLargest);
  EXPECT_EQ(flat.max.z(), kLargest);
  const Aabb tilted = bounding_aabb(Shape(Plane{{1, 1, 0}, 0}));
  EXPECT_EQ(tilted.min, Vector3d::Constant(-kLargest));
  EXPECT_EQ(tilted.max, Vector3d::Constant(kLargest));
}

TEST(Planes, AreCheckedAtTheDoor) {
  EXPECT_THROW(Shape(Plane{{0, 0, 0}, 1}), InputError);
  EXPECT_THROW(Shape(Plane{{0, NAN, 1}, 1}), InputError);
  EXPECT_THROW(Shape(Plane{{0, 0, 1}, INFINITY}), InputError);
  const Shape scaled = Plane{{0, 0, 4}, 8};
  EXPECT_EQ(scaled.as<Plane>()->normal, Vector3d(0, 0, 1));
  EXPECT_EQ(scaled.as<Plane>()->offset, 2);
  try {
    Shape(Plane{{0, 0, 0}, 1});
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "plane: the normal is zero");
  }
}

/// The numbers that a shape has, to the bit.
template <typename Flat>
std::array<double, 4> numbers_of(const Shape& shape) {
  const Flat& flat = *shape.as<Flat>();
  return {flat.normal.x(), flat.normal.y(), flat.normal.z(), flat.offset};
}

template <typename Flat>
void expect_same_made_again(const Flat& flat) {
  const Shape once(flat), again(*once.as<Flat>());
  EXPECT_EQ(numbers_of<Flat>(once), numbers_of<Flat>(again));
  EXPECT_NEAR(once.as<Flat>()->normal.norm(), 1, 0x1p-50);
}

TEST(PlaneNumbers, AShapeMadeFromAnothersNumbersIsTheSame) {
  RandomSource source(77);
  for (int i = 0; i < 20000; ++i) {
    const double length = source.uniform_at_scale(1, 2, -30, 30);
    const Vector3d normal = source.vector(-1, 1) * length;
    const double offset = source.uniform(-1, 1) * normal.norm();
    expect_same_made_again(HalfSpace{normal, offset});
    expect_same_made_again(Plane{normal, offset});
  }
  // What is of length 1 but for some units in the last place, in whatever way, stays as it is.
  const Vector3d nearly = Vector3d(0.6, 0.8, 0) * (1 + 0x1p-52);
  EXPECT_EQ(Shape(HalfSpace{nearly, 3}).as<HalfSpace>()->normal, nearly);
  EXPECT_NE(Shape(HalfSpace{nearly * (1 + 0x1p-40), 3}).as<HalfSpace>()->normal.x(),
            nearly.x() * (1 + 0x1p-40));
}

}  // namespace
}  // namespace graze
