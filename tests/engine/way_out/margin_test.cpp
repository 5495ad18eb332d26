// Law 15 with a margin: contacts of bodies that are near, whose depths are negative.

#include <graze/bvh/error.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "tests/engine/way_out/tessellated.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

const Vector3d kDown(0, 0, -1);  // from a body above to what it lies on

std::vector<Shape> bodies(int n, RandomSource& source) {
  std::vector<Shape> all;
  for (const ShapeKind kind :
       {ShapeKind::Sphere, ShapeKind::Box, ShapeKind::Capsule, ShapeKind::Cylinder, ShapeKind::Cone,
        ShapeKind::Ellipsoid, ShapeKind::ConvexHull})
    all.push_back(tests::random_shape(kind, 0.4, source));
  for (const auto kind : tests::kConvexMeshKinds)
    all.push_back(tests::convex_mesh(kind, n % 3, source));
  return all;
}

double deepest(const Manifold& found) {
  double most = -std::numeric_limits<double>::infinity();
  for (const ShapeContact& contact : found)
    most = std::max(most, contact.depth);
  return most;
}

/// Moves B along x until the two are so far apart, and says how far that is.
double set_apart(const Shape& a, const Pose& pose_a, const Shape& b, Pose& pose_b, double gap) {
  for (int i = 0; i < 60; ++i) {
    const double now = distance({a, pose_a}, {b, pose_b}).distance;
    if (now > 0 && std::abs(now - gap) <= 1e-3 * gap) return now;
    const double by = now == 0 ? 0.05 : gap - now;
    pose_b.translation() += Vector3d(by, 0, 0);
  }
  return distance({a, pose_a}, {b, pose_b}).distance;
}

TEST(Margin, Law15ThereAreContactsExactlyUpToTheMargin) {
  RandomSource source(1501);
  int near = 0, apart = 0;
  for (int n = 0; n < 12; ++n) {
    const std::vector<Shape> all = bodies(n, source);
    for (const Shape& a : all) {
      for (const Shape& b : all) {
        const Pose pose_a = tests::random_pose(0, source);
        Pose pose_b = tests::random_pose(0, source);
        pose_b.translation() = pose_a.translation() + Vector3d(0.2, 0.02, 0.05);
        const double gap = set_apart(a, pose_a, b, pose_b, std::pow(10, source.uniform(-4, -1.5)));
        for (const double factor : {0.5, 0.99, 1.01, 3.0}) {
          const double margin = factor * gap;
          const Manifold found = find_contacts({a, pose_a}, {b, pose_b}, {.margin = margin});
          SCOPED_TRACE((std::ostringstream() << n << " " << name_of(a.kind()) << " "
                                             << name_of(b.kind()) << " " << gap << " " << factor)
                           .str());
          ASSERT_EQ(found.empty(), factor < 1);
          ++(found.empty() ? apart : near);
          if (found.empty()) continue;
          const bool has_mesh = a.kind() == ShapeKind::Mesh || b.kind() == ShapeKind::Mesh;
          ASSERT_NEAR(deepest(found), -gap, 1e-6 + (has_mesh ? 0.05 * gap : 0));
          for (const ShapeContact& contact : found) {
            ASSERT_LE(contact.depth, 0);
            ASSERT_GE(contact.depth, -margin * (1 + 1e-9));
            ASSERT_LE((contact.point_a - contact.point_b - contact.depth * contact.normal).norm(),
                      0x1p-16);
          }
        }
      }
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(apart, 1000);
}

/// Above a floor each contact is as far from it as its point is.
TEST(Margin, Law15EachPointHasItsOwnHeight) {
  RandomSource source(1502);
  for (int n = 0; n < 40; ++n) {
    const Vector3d half(0.3, 0.2, 0.1);
    const Mesh floor = tests::tessellated_box({2, 2, 0.5}, 1 + n % 5);
    const double gap = std::pow(10, source.uniform(-4, -2));
    const double angle = source.uniform(0.001, 0.02);
    Pose pose = tests::at({source.uniform(-1, 1), source.uniform(-1, 1), 0});
    pose.linear() = (Eigen::AngleAxisd(source.uniform(-3, 3), Vector3d(0, 0, 1)) *
                     Eigen::AngleAxisd(angle, Vector3d(0, 1, 0)))
                        .toRotationMatrix();
    pose.translation().z() = 0.5 + gap + half.x() * std::sin(angle) + half.z() * std::cos(angle);
    const double margin = gap + 2 * half.x() * std::sin(angle) + 1e-3;
    for (const Shape& body : {Shape(Box{half}), Shape(tests::tessellated_box(half, 1 + n % 3))}) {
      for (const Shape& below :
           {Shape(floor), Shape(Box{{2, 2, 0.5}}), Shape(HalfSpace{{0, 0, 1}, 0.5})}) {
        const Manifold found =
            find_contacts({body, pose}, {below, Pose::Identity()}, {.margin = margin});
        SCOPED_TRACE((std::ostringstream()
                      << n << " " << name_of(body.kind()) << " " << name_of(below.kind()))
                         .str());
        ASSERT_EQ(found.size(), 4u);
        double least = 0, most = -1;
        for (const ShapeContact& contact : found) {
          ASSERT_NEAR(std::abs(contact.normal.dot(kDown)), 1, 1e-9 + angle * angle);
          const double height = contact.point_a.z() - 0.5;
          ASSERT_NEAR(contact.depth, -height, 1e-9 + angle * angle * margin);
          least = std::min(least, contact.depth), most = std::max(most, contact.depth);
        }
        ASSERT_NEAR(most, -gap, 1e-9 + angle * angle * margin);
        ASSERT_NEAR(least, -gap - 2 * half.x() * std::sin(angle), 1e-9 + angle * angle * margin);
      }
    }
  }
}

/// A box and its mesh are as near, along directions that part the two as well.
TEST(Margin, Law15ABodyIsABody) {
  RandomSource source(1505);
  const auto extents = [&] {
    return Vector3d{source.uniform(0.1, 0.6), source.uniform(0.1, 0.6), source.uniform(0.1, 0.6)};
  };
  int asked = 0;
  for (int n = 0; n < 1500; ++n) {
    const Vector3d half_a = extents(), half_b = extents();
    const Shape box_a = Box{half_a}, box_b = Box{half_b};
    const Shape mesh_a = tests::tessellated_box(half_a, 1 + n % 4);
    const Shape mesh_b = tests::tessellated_box(half_b, 1 + n % 3);
    const bool is_aligned = n % 4 == 0;
    const Pose pose_a = is_aligned ? Pose(Pose::Identity()) : tests::random_pose(0, source);
    Pose pose_b = is_aligned ? Pose(Pose::Identity()) : tests::random_pose(0, source);
    pose_b.translation() =
        1.5 * Vector3d{source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(-1, 1)};
    const ShapeDistance far = distance({box_a, pose_a}, {box_b, pose_b});
    const double gap = std::pow(10, source.uniform(-5, -1));
    pose_b.translation() -= far.normal * (far.distance - gap);
    const double apart = distance({box_a, pose_a}, {box_b, pose_b}).distance;
    if (far.distance == 0 || apart == 0) continue;
    ++asked;
    const double margin = apart * source.uniform(1.0001, 4);
    for (const auto& [a, b] : {std::pair{box_a, mesh_b}, {mesh_a, box_b}, {mesh_a, mesh_b}}) {
      const Manifold found = find_contacts({a, pose_a}, {b, pose_b}, {.margin = margin});
      SCOPED_TRACE((std::ostringstream()
                    << n << " " << name_of(a.kind()) << " " << name_of(b.kind()) << " " << apart)
                       .str());
      ASSERT_NEAR(deepest(found), -apart, 0.05 * apart + 1e-9);
      // How far apart the boxes are along the normal.
      double end_a = -1e9, begin_b = 1e9;
      const Vector3d& normal = found[0].normal;
      for (int corner = 0; corner < 8; ++corner) {
        const Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                            (corner & 4) != 0 ? 1 : -1);
        end_a = std::max(end_a, normal.dot(pose_a * Vector3d(sign.cwiseProduct(half_a))));
        begin_b = std::min(begin_b, normal.dot(pose_b * Vector3d(sign.cwiseProduct(half_b))));
      }
      ASSERT_NEAR(begin_b - end_a, apart, 0.05 * apart + 1e-9);
    }
  }
  EXPECT_GT(asked, 1000);
}

/// What touches is as deep with a margin as without, and its way is the same.
TEST(Margin, Law15WhatTouchesIsAsDeepAsWithout) {
  RandomSource source(1503);
  for (int n = 0; n < 30; ++n) {
    const Mesh floor = tests::tessellated_box({2, 2, 0.5}, 1 + n % 5);
    for (const Shape& body : bodies(n, source)) {
      Pose pose = tests::random_pose(0, source);
      const double x = source.uniform(-1, 1), y = source.uniform(-1, 1);
      pose.translation().setZero();
      pose.translation() = Vector3d(x, y, 0.52 + tests::reach_of(body, pose, kDown));
      for (int i = 0; i < 60 && !intersects({body, pose}, {floor, Pose::Identity()}); ++i)
        pose.translation().z() -= 0.01;
      const Manifold bare = find_contacts({body, pose}, {floor, Pose::Identity()});
      const Manifold found =
          find_contacts({body, pose}, {floor, Pose::Identity()}, {.margin = 0.02});
      SCOPED_TRACE((std::ostringstream() << n << " " << name_of(body.kind())).str());
      ASSERT_FALSE(bare.empty());
      ASSERT_NEAR(deepest(found), deepest(bare), 1e-6);
      ASSERT_LE((found[0].normal - bare[0].normal).norm(), 1e-6);
    }
  }
}

TEST(Margin, Law15WithoutOneNothingChanges) {
  RandomSource source(1504);
  for (int n = 0; n < 4; ++n) {
    const std::vector<Shape> all = bodies(n, source);
    for (const Shape& a : all) {
      for (const Shape& b : all) {
        const Pose pose_a = tests::random_pose(0, source), pose_b = tests::random_pose(0.2, source);
        ASSERT_EQ(find_contacts({a, pose_a}, {b, pose_b}, {.margin = 0}),
                  find_contacts({a, pose_a}, {b, pose_b}));
      }
    }
  }
}

/// As for a ball in a hollow box.
TEST(Margin, Law15BehindASurfaceTheNearestPointsAreTheContact) {
  const Mesh hollow = tests::tessellated_box({1, 1, 1}, 3);
  const Pose pose = tests::at(0.7, 0.1, 0.05);
  const Sphere ball{{0, 0, 0}, 0.25};
  const Manifold found = find_contacts({ball, pose}, {hollow, Pose::Identity()}, {.margin = 0.1});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, -0.05, 1e-12);
  EXPECT_LE((found[0].normal - Vector3d(1, 0, 0)).norm(), 1e-9);
}

/// However large, a margin takes nothing from depths.
TEST(Margin, Law15DepthsBesideAHugeMarginAreAsExact) {
  const Mesh mesh = tests::tessellated_box({1, 1, 1}, 2);
  const Shape shapes[] = {Box{{1, 1, 1}}, Sphere{{0, 0, 0}, 1}, mesh};
  for (const Shape& a : shapes) {
    for (const Shape& b : {shapes[0], shapes[1], shapes[2], Shape(HalfSpace{{-1, 0, 0}, 1})}) {
      for (const double margin : {1e3, 1e30, 1e150, 1e300}) {
        const bool is_plane = b.kind() == ShapeKind::HalfSpace;
        const Manifold found = find_contacts(
            {a, tests::at(0, 0, 0)}, {b, tests::at(is_plane ? 4 : 3.9, 0, 0)}, {.margin = margin});
        ASSERT_FALSE(found.empty());
        EXPECT_NEAR(deepest(found), -(is_plane ? 2 : 1.9), 1e-9)
            << name_of(a.kind()) << " " << name_of(b.kind()) << " " << margin;
      }
    }
  }
}

TEST(Margin, OnesThatAreNoneAreRefused) {
  const Box box{{1, 1, 1}};
  for (const double margin : {-1e-300, -1.0, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(find_contacts({box}, {box}, {.margin = margin}), InputError);
  }
}

}  // namespace
}  // namespace graze
