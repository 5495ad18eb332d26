// Rays at shapes by definitions that share nothing with the formulas, and at worlds beside rays at
// each body.

#include <graze/bvh/error.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;

using tests::at;

/// The ray as a thin capsule of that length.
std::pair<Capsule, Pose> as_capsule(const Ray& ray, double length) {
  const Vector3d unit = ray.direction.normalized();
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), unit).toRotationMatrix();
  pose.translation() = ray.origin + unit * (0.5 * length);
  return {Capsule{1e-9 * length, 0.5 * length}, pose};
}

/// A hit is on the surface and nothing before it is inside; a ray that misses goes through no
/// inside, as the solver for two convex shapes sees it.
bool expect_as_defined(const Shape& shape, const Pose& pose, const Ray& ray, double scale,
                       RandomSource& source) {
  const auto hit = cast_ray({shape, pose}, ray);
  const Vector3d unit = ray.direction.normalized();
  const double tolerance = 1e-9 * scale;
  if (!hit) {
    if (shape.kind() == ShapeKind::HalfSpace) {
      EXPECT_GT(tests::outside_by(shape, pose, ray.origin), -tolerance);
      EXPECT_GT(tests::outside_by(shape, pose, ray.origin + unit * scale), -tolerance);
      return false;
    }
    const auto [capsule, place] = as_capsule(ray, 6 * scale);
    if (!intersects({shape, pose}, {capsule, place})) return false;
    const Manifold contacts = find_contacts({shape, pose}, {capsule, place});
    for (std::size_t i = 0; i < contacts.size(); ++i)
      EXPECT_LT(contacts[i].depth, 2e-7 * scale);
    return false;
  }
  EXPECT_NEAR((hit->point - (ray.origin + unit * hit->distance)).norm(), 0, tolerance);
  EXPECT_NEAR(hit->normal.norm(), 1, 1e-12);
  EXPECT_LE(hit->normal.dot(unit), 1e-9);
  const double outside = tests::outside_by(shape, pose, hit->point);
  if (hit->distance == 0) {
    EXPECT_LE(outside, tolerance);
    EXPECT_EQ(hit->triangle, kNoTriangle);
    return true;
  }
  EXPECT_NEAR(outside, 0, tolerance);
  for (int i = 0; i < 10; ++i) {
    const double s = source.uniform(0, hit->distance - 1e-4 * scale);
    if (s > 0) {
      EXPECT_GT(tests::outside_by(shape, pose, ray.origin + unit * s), 0) << s;
    }
  }
  // Along the normal the surface is met head on: the next point outward is outside.
  EXPECT_GT(tests::outside_by(shape, pose, hit->point + hit->normal * (1e-5 * scale)), 0);
  return true;
}

TEST(ShapeRay, MeetsEveryKindAsItIsDefined) {
  RandomSource source(1);
  for (const ShapeKind kind : tests::kOwnKinds) {
    SCOPED_TRACE(name_of(kind));
    int hits = 0, starts_inside = 0;
    const int count = kind == ShapeKind::Mesh ? 300 : 1500;
    for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
      const double size = n % 5 == 0 ? std::exp2(source.uniform(-60, 60)) : 1;
      const Shape shape = tests::random_shape(kind, size, source);
      const Pose pose = tests::random_pose(size, source);
      Ray ray{pose.translation() + source.vector(-3, 3) * size, {}};
      if (n % 8 == 0) ray.origin = pose.translation() + source.vector(-0.1, 0.1) * size;
      ray.direction = pose.translation() + source.vector(-0.8, 0.8) * size - ray.origin;
      if (n % 7 == 0) ray.direction = pose.linear().col(static_cast<int>(source.integer(0, 2)));
      const bool is_hit = expect_as_defined(shape, pose, ray, 6 * size, source);
      const auto hit = cast_ray({shape, pose}, ray);
      hits += is_hit;
      starts_inside += hit && hit->distance == 0;
      if (!hit) continue;
      ray.max_distance = hit->distance;  // a ray that ends there still meets it
      EXPECT_TRUE(cast_ray({shape, pose}, ray));
      ray.max_distance = 0.999 * hit->distance;
      EXPECT_EQ(cast_ray({shape, pose}, ray).has_value(), hit->distance == 0);
      ray.direction *= 1e-200;
      ray.max_distance = HUGE_VAL;
      ASSERT_TRUE(cast_ray({shape, pose}, ray));
      EXPECT_NEAR(cast_ray({shape, pose}, ray)->distance, hit->distance,
                  1e-10 * (size + hit->distance));
    }
    EXPECT_GT(hits, count / 4);
    if (kind != ShapeKind::Mesh) {
      EXPECT_GT(starts_inside, count / 20);
    }
  }
}

TEST(ShapeRay, IsAccurateFromFarAway) {
  for (const ShapeKind kind : tests::kOwnKinds) {
    SCOPED_TRACE(name_of(kind));
    RandomSource source(2);
    const Shape shape = tests::random_shape(kind, 1, source);
    const auto far = cast_ray({shape, at(1e6, 0, 0)}, {{1e6 - 1e9, 0.01, 0.02}, {1, 0, 0}});
    const auto near = cast_ray({shape, at(0, 0, 0)}, {{-1e3, 0.01, 0.02}, {1, 0, 0}});
    ASSERT_EQ(far.has_value(), near.has_value());
    if (far) {
      EXPECT_NEAR(far->distance - 1e9, near->distance - 1e3, 1e-5);
    }
  }
  EXPECT_FALSE(cast_ray({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)}, {{-1e300, 0, 0}, {-1, 0, 0}}));
  EXPECT_TRUE(cast_ray({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)}, {{-1.7e308, 0, 0}, {1, 0, 0}}));
}

TEST(ShapeRay, KnowsTheSimpleAnswers) {
  const auto cone = cast_ray({Cone{1, 1}, at(0, 0, 0)}, {{0, 0, 5}, {0, 0, -2}});  // on the apex
  ASSERT_TRUE(cone);
  EXPECT_NEAR(cone->distance, 4, 1e-12);
  const auto along = cast_ray({Cone{1, 1}, at(0, 0, 0)}, {{-0.5, 0, -5}, {0, 0, 1}});
  ASSERT_TRUE(along);
  EXPECT_EQ(along->distance, 4);
  EXPECT_EQ(along->normal, Vector3d(0, 0, -1));
  // Along the side of the cone, x + z / 2 = 1 / 2, a bit within and a bit outside.
  EXPECT_TRUE(cast_ray({Cone{1, 1}, at(0, 0, 0)}, {{2 - 1e-6, 0, -3}, {-0.5, 0, 1}}));
  EXPECT_FALSE(cast_ray({Cone{1, 1}, at(0, 0, 0)}, {{2 + 1e-6, 0, -3}, {-0.5, 0, 1}}));
  const auto box = cast_ray({Box{{1, 2, 3}}, at(10, 0, 0)}, {{0, 1, 1}, {1, 0, 0}});
  ASSERT_TRUE(box);
  EXPECT_EQ(box->distance, 9);
  EXPECT_EQ(box->point, Vector3d(9, 1, 1));
  EXPECT_EQ(box->normal, Vector3d(-1, 0, 0));
  const auto end = cast_ray({Capsule{1, 2}, at(0, 0, 0)}, {{0, 0, 9}, {0, 0, -1}});
  ASSERT_TRUE(end);
  EXPECT_EQ(end->distance, 6);
  const auto plane = cast_ray({HalfSpace{{0, 0, 2}, 2}, at(0, 0, 0)}, {{5, 5, 4}, {0, 0, -1}});
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->distance, 3);
  EXPECT_FALSE(cast_ray({HalfSpace{{0, 0, 2}, 2}, at(0, 0, 0)}, {{5, 5, 4}, {1, 0, 0}}));
  EXPECT_THROW(cast_ray({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)}, {{0, 0, 0}, {0, 0, 0}}), InputError);
  EXPECT_THROW(cast_ray({Box{{1, 1, 1}}, at(2e100, 0, 0)}, {{0, 0, 0}, {1, 0, 0}}), PoseError);
}

void expect_equal(const BodyRayHit& s, const BodyRayHit& t) {
  EXPECT_EQ(s.id, t.id);
  EXPECT_EQ(s.hit.distance, t.hit.distance);
  EXPECT_EQ(s.hit.point, t.hit.point);
  EXPECT_EQ(s.hit.normal, t.hit.normal);
  EXPECT_EQ(s.hit.triangle, t.hit.triangle);
}

struct Body {
  Shape shape;
  Pose pose;
  Filter filter;
};

std::vector<BodyRayHit> brute_force(const std::map<BodyId, Body>& bodies, const Ray& ray,
                                    const BodyQuerySettings& query) {
  std::vector<BodyRayHit> hits;
  for (const auto& [id, body] : bodies) {
    if (query.filter && !lets_pass(*query.filter, body.filter)) continue;
    if (const auto hit = cast_ray({body.shape, body.pose}, ray)) hits.push_back({id, *hit});
  }
  std::sort(hits.begin(), hits.end(), [](const BodyRayHit& s, const BodyRayHit& t) {
    return std::tie(s.hit.distance, s.id) < std::tie(t.hit.distance, t.id);
  });
  return hits;
}

/// Law 9: with bodies that came, moved and went since the last update.
TEST(WorldRay, TheBroadPhaseIsBruteForce) {
  RandomSource source(3);
  World world;
  std::map<BodyId, Body> bodies;
  std::size_t found = 0;
  for (int round = 0; round < 120; ++round) {
    for (int i = round == 0 ? 150 : 4; i > 0; --i) {
      const auto kind = tests::kOwnKinds[static_cast<std::size_t>(source.integer(0, 8))];
      if (kind == ShapeKind::HalfSpace && round % 40 != 1) continue;
      Body body{tests::random_shape(kind, 0.8, source), tests::random_pose(8, source), {}};
      body.filter.category = i % 2 == 0 ? 1 : 2;
      bodies.emplace(world.add({body.shape, body.pose}, {.filter = body.filter}), body);
    }
    for (int i = 0; i < 6; ++i) {
      const auto any = std::next(
          bodies.begin(), static_cast<int>(source.uniform(0, static_cast<double>(bodies.size()))));
      if (i < 3) {
        world.remove(any->first);
        bodies.erase(any);
      } else {
        any->second.pose = tests::random_pose(8, source);
        world.move(any->first, any->second.pose);
      }
    }
    if (round % 2 == 0) world.update();
    for (int i = 0; i < 12; ++i) {
      const auto any = std::next(
          bodies.begin(), static_cast<int>(source.uniform(0, static_cast<double>(bodies.size()))));
      Ray ray{source.vector(-10, 10), {}};
      ray.direction = any->second.pose.translation() + source.vector(-0.5, 0.5) - ray.origin;
      if (i % 4 == 0) ray.direction = Vector3d::Unit(static_cast<int>(source.integer(0, 2)));
      if (i % 3 == 0) ray.max_distance = source.uniform(0, 10);
      if (i % 5 == 0) ray.origin -= 1e4 * ray.direction;
      BodyQuerySettings query;
      if (i % 6 == 0) query.filter = Filter{.mask = 2};
      const std::vector<BodyRayHit> expected = brute_force(bodies, ray, query);
      const std::vector<BodyRayHit> all = world.cast_ray_all(ray, query);
      ASSERT_EQ(all.size(), expected.size());
      for (std::size_t k = 0; k < all.size(); ++k)
        expect_equal(all[k], expected[k]);
      const auto first = world.cast_ray(ray, query);
      ASSERT_EQ(first.has_value(), !expected.empty());
      if (first) expect_equal(*first, expected[0]);
      found += all.size();
    }
    ASSERT_FALSE(HasFailure()) << round;
  }
  EXPECT_GT(found, 800u);
}

/// A shape of a user's own that knows nothing of rays.
class Blind : public BodyShape {
 public:
  Aabb bounds(const Pose& pose) const override {
    return {pose.translation(), pose.translation() + Vector3d::Ones()};
  }
  bool touches(const Pose&, const BodyShape&, const Pose&) const override { return false; }
};

TEST(WorldRay, TiesGoToTheSmallerIdAndTheUnknownIsNotFree) {
  World world;
  EXPECT_FALSE(world.cast_ray({{0, 0, 0}, {1, 0, 0}}));
  const BodyId first = world.add({Box{{1, 1, 1}}, at(5, 0, 0)});
  world.add({Box{{1, 1, 1}}, at(5, 0, 0)});
  world.update();
  EXPECT_EQ(world.cast_ray({{0, 0, 0}, {1, 0, 0}})->id, first);
  EXPECT_EQ(world.cast_ray_all({{0, 0, 0}, {1, 0, 0}}).size(), 2u);
  EXPECT_FALSE(world.cast_ray({{0, 0, 0}, {1, 0, 0}, 3.9}));
  EXPECT_THROW(world.cast_ray({{0, 0, 0}, {0, 0, 0}}), InputError);
  world.add({std::make_shared<Blind>(), at(2, -0.5, -0.5)});
  EXPECT_THROW(world.cast_ray({{0, 0, 0}, {1, 0, 0}}), UnsupportedPairError);
  EXPECT_TRUE(world.cast_ray({{5, 5, 0}, {0, -1, 0}}));
}

TEST(BroadPhaseRay, FindsAllBoxesOnTheWay) {
  RandomSource source(4);
  BroadPhase boxes;
  std::vector<Aabb> placed;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d low = source.lattice_point(-40, 40);
    placed.push_back({low, low + source.lattice_point(0, i % 9 == 0 ? 30 : 2)});
    boxes.add(placed.back());
    if (i == 2900) boxes.update();
  }
  std::size_t found = 0;
  for (int n = 0; n < 300; ++n) {
    // On a lattice, so that rays run along faces and through corners.
    Ray ray{source.lattice_point(-45, 45), source.lattice_point(-1, 1)};
    if (ray.direction.isZero()) continue;
    if (n % 3 == 0) ray.max_distance = source.uniform(0, 50);
    std::set<std::uint32_t> seen;
    boxes.visit_along(ray, [&](std::uint32_t index) {
      EXPECT_TRUE(seen.insert(index).second);
      return ray.max_distance;
    });
    for (std::uint32_t i = 0; i < placed.size(); ++i) {
      // Exactly: all numbers are small integers, but for the end.
      double enter = 0, exit = 1e9;
      for (int k = 0; k < 3; ++k) {
        const double o = ray.origin[k], d = ray.direction[k];
        const double low = placed[i].min[k] - o, high = placed[i].max[k] - o;
        if (d == 0 && (low > 0 || high < 0)) exit = -1;
        if (d != 0) enter = std::max(enter, std::min(low * d, high * d));
        if (d != 0) exit = std::min(exit, std::max(low * d, high * d));
      }
      const bool is_met =
          enter <= exit && enter * ray.direction.norm() <= ray.max_distance * (1 - 1e-12);
      if (is_met) {
        EXPECT_TRUE(seen.contains(i)) << n << " " << i;
      }
      found += is_met;
      const bool is_near = enter <= exit && enter * ray.direction.norm() <= ray.max_distance;
      if (!is_near) {
        EXPECT_FALSE(seen.contains(i)) << n << " " << i;
      }
    }
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(found, 1000u);
}

}  // namespace
}  // namespace graze
