// Each question about a height field beside the same about its mesh: yes or no, distances, rays.

#include <graze/engine/print.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/shape_separation.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/height_fields/random_fields.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::FieldTwins;
using tests::Ground;
using tests::random_pose;
using tests::random_shape;

/// A field in a pose, and shapes near it.
class Scene {
 public:
  Scene(int n, RandomSource& source)
      : twins_(tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source).field()) {
    if (n % 3 != 0) pose_ = random_pose(n % 3 == 1 ? 2 : 500, source);
  }
  const FieldTwins& twins() const { return twins_; }
  const Pose& pose() const { return pose_; }
  PlacedShapeView field() const { return {twins_.field(), pose_}; }
  PlacedShapeView mesh() const { return {twins_.mesh(), pose_}; }

 private:
  FieldTwins twins_;
  Pose pose_ = Pose::Identity();
};

TEST(HeightFieldQueries, TheBoxIsThatOfTheMesh) {
  RandomSource source(3);
  for (int n = 0; n < 100; ++n) {
    const Scene scene(n, source);
    EXPECT_EQ(bounding_aabb(scene.field()), bounding_aabb(scene.mesh()));
  }
}

TEST(HeightFieldQueries, MeetsWhatTheMeshMeets) {
  RandomSource source(4);
  int hits = 0, misses = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene(n, source);
    for (const ShapeKind kind : kShapeKinds) {
      if (kind >= ShapeKind::HeightField) continue;
      const Shape shape = random_shape(kind, source.integer(0, 3) == 0 ? 4 : 0.6, source);
      const Pose pose = pose_near(scene.twins(), scene.pose(), source);
      const bool is_hit = intersects(scene.field(), {shape, pose});
      EXPECT_EQ(is_hit, intersects(scene.mesh(), {shape, pose})) << n << name_of(kind);
      EXPECT_EQ(is_hit, intersects({shape, pose}, scene.field()));
      (is_hit ? hits : misses)++;
    }
  }
  EXPECT_GT(hits, 800);
  EXPECT_GT(misses, 500);
}

TEST(HeightFieldQueries, IsAsFarAwayAsTheMesh) {
  RandomSource source(5);
  int apart = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene(n, source);
    for (const ShapeKind kind : kShapeKinds) {
      if (kind >= ShapeKind::HeightField) continue;
      const Shape shape = random_shape(kind, source.integer(0, 3) == 0 ? 4 : 0.6, source);
      Pose pose = pose_near(scene.twins(), scene.pose(), source);
      if (n % 2 == 0) pose.translation() += source.vector(-4, 4);
      ShapeDistance found = distance(scene.field(), {shape, pose});
      const ShapeDistance wanted = distance(scene.mesh(), {shape, pose});
      if (found.distance > 0) ++apart;
      // The bound is as good, but in its last bits it depends on what a tree lets a search see.
      EXPECT_NEAR(found.lower_bound, wanted.lower_bound, 1e-9 * (1 + wanted.distance));
      EXPECT_LE(found.lower_bound, found.distance);
      found.lower_bound = wanted.lower_bound;
      // Of several lowest points any; of meshes that meet, the points of any two triangles.
      if (kind == ShapeKind::HalfSpace || (kind == ShapeKind::Mesh && found.distance == 0)) {
        EXPECT_EQ(found.distance, wanted.distance) << n << name_of(kind);
        continue;
      }
      EXPECT_EQ(found, wanted) << n << name_of(kind);
      found = distance({shape, pose}, scene.field());
      EXPECT_EQ(found.point_b, wanted.point_a);
      EXPECT_EQ(found.distance, wanted.distance);
    }
  }
  EXPECT_GT(apart, 1000);
}

TEST(HeightFieldQueries, TwoFieldsAreAsTheirMeshes) {
  RandomSource source(6);
  int hits = 0;
  for (int n = 0; n < 200; ++n) {
    const Scene a(n, source);
    const FieldTwins b(tests::random_parts(Ground::Rough, source).field());
    Pose pose = pose_near(a.twins(), a.pose(), source);
    pose.translation() += source.vector(-3, 3);
    const bool is_hit = intersects(a.field(), {b.field(), pose});
    hits += is_hit;
    EXPECT_EQ(is_hit, intersects(a.mesh(), {b.mesh(), pose}));
    const ShapeDistance found = distance(a.field(), {b.field(), pose});
    EXPECT_EQ(found.distance, distance(a.mesh(), {b.mesh(), pose}).distance);
  }
  EXPECT_GT(hits, 50);
  EXPECT_LT(hits, 190);
}

TEST(HeightFieldQueries, RaysMeetWhatTheyMeetOfTheMesh) {
  RandomSource source(7);
  int hits = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene(n, source);
    const HeightField& field = scene.twins().value();
    for (int i = 0; i < 30; ++i) {
      Ray ray{scene.pose() * (source.vector(-4, 12)), source.vector(-1, 1)};
      const auto at = [&] {
        const double column = source.integer(0, static_cast<int>(field.columns()) - 1);
        const double row = source.integer(0, static_cast<int>(field.rows()) - 1);
        return scene.pose() *
               field.vertex(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
      };
      if (i % 3 == 0) ray.direction = at() - ray.origin;  // through vertices
      if (i % 3 == 1) {
        const Eigen::Vector3d to = at();  // along edges, diagonals and flat ground
        ray.origin = at();
        if (to != ray.origin) ray.direction = to - ray.origin;
      }
      if (i % 5 == 0) ray.direction = scene.pose().linear() * Eigen::Vector3d(0, 0, -1);
      if (i % 7 == 0) ray.max_distance = source.uniform(0, 8);
      const auto found = cast_ray(scene.field(), ray);
      auto wanted = cast_ray(scene.mesh(), ray);
      ASSERT_EQ(found.has_value(), wanted.has_value()) << n << " " << i;
      if (!found) continue;
      ++hits;
      wanted->triangle = scene.twins().number(wanted->triangle);
      EXPECT_EQ(*found, *wanted) << n << " " << i;
    }
  }
  EXPECT_GT(hits, 3000);
}

TEST(HeightFieldQueries, FarAwayAndHugeOnesAreStillTheirMeshes) {
  RandomSource source(8);
  for (int n = 0; n < 60; ++n) {
    tests::FieldParts parts = tests::random_parts(Ground::Rough, source);
    const double scale = n % 2 == 0 ? 1e6 : 1e-6;
    parts.settings.spacing_x *= scale, parts.settings.spacing_y *= scale;
    parts.settings.height_scale *= scale, parts.settings.height_offset *= scale;
    const FieldTwins twins(parts.field());
    Pose field_pose = random_pose(1, source);
    field_pose.translation() *= n % 3 == 0 ? 1e9 * scale : 3 * scale;
    const Pose pose = pose_near(twins, field_pose, source);
    for (const double size : {0.001 * scale, scale, 30 * scale}) {
      const Shape ball = Sphere{{0, 0, 0}, size}, box = Box{{size, size / 2, size}};
      for (const Shape* shape : {&ball, &box}) {
        EXPECT_EQ(intersects({twins.field(), field_pose}, {*shape, pose}),
                  intersects({twins.mesh(), field_pose}, {*shape, pose}));
        EXPECT_EQ(distance({twins.field(), field_pose}, {*shape, pose}).distance,
                  distance({twins.mesh(), field_pose}, {*shape, pose}).distance);
      }
    }
  }
}

TEST(HeightFieldQueries, LooksOnlyAtCellsThatAreNear) {
  tests::FieldParts parts;
  parts.columns = parts.rows = 1000;
  for (std::uint32_t i = 0; i < 1000 * 1000; ++i)
    parts.heights.push_back(static_cast<float>(std::sin(0.01 * i) + std::cos(0.013 * (i / 1000))));
  const Shape field = parts.field();
  const Shape box = Box{{1, 1, 1}};
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d{500.3, 499.7, 1};
  Work work;
  EXPECT_TRUE(intersects({field}, {box, pose}, &work));
  EXPECT_LE(work.triangle_tests, 4u * 4 * 2);
  work = {};
  pose.translation().z() = 10;
  EXPECT_FALSE(intersects({field}, {box, pose}, &work));
  EXPECT_EQ(work.triangle_tests, 0u);
  distance({field}, {box, pose}, &work);
  EXPECT_LE(work.triangle_tests, 600u);
  work = {};
  // Down at a slant across a hundred cells, of which it is low over few.
  EXPECT_TRUE(cast_ray({field}, {{450, 500, 20}, {5, 0.3, -1}}, &work).has_value());
  EXPECT_LE(work.triangle_tests, 60u);
  EXPECT_LE(work.volume_tests, 900u);
}

TEST(HeightFieldQueries, RefusesWhatAMeshRefuses) {
  RandomSource source(9);
  const Scene scene(0, source);
  const Shape ball = Sphere{{0, 0, 0}, 1};
  Pose bent = Pose::Identity();
  bent.linear()(0, 1) = 0.1;
  EXPECT_THROW(intersects({scene.twins().field(), bent}, {ball}), PoseError);
  EXPECT_THROW(distance({ball}, {scene.twins().field(), bent}), PoseError);
  EXPECT_THROW(cast_ray({scene.twins().field(), bent}, Ray{{0, 0, 5}, {0, 0, -1}}), PoseError);
  EXPECT_THROW(find_separation(scene.field(), {ball}), UnsupportedPairError);
  EXPECT_THROW(cast_ray(scene.field(), Ray{{0, 0, 5}, {0, 0, 0}}), InputError);
}

}  // namespace
}  // namespace graze
