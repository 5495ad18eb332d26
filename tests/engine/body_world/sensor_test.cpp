// Sensors and bodies that change their shape, beside all pairs asked one by one.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using tests::at;

struct Body {
  BodyId id;
  Shape shape;
  Pose pose;
  BodyKind kind;
  Role role;
};

/// Spelt out from the table: rows and columns static, kinematic, dynamic, then sensors of any
/// motion.
bool are_of_interest(const Body& s, const Body& t) {
  constexpr bool kMeets[4][4] = {
      {false, false, true, false},
      {false, false, true, true},
      {true, true, true, true},
      {false, true, true, false},
  };
  const auto row = [](const Body& b) {
    if (b.role == Role::Sensor) return 3;
    return b.kind == BodyKind::Static ? 0 : b.kind == BodyKind::Kinematic ? 1 : 2;
  };
  return kMeets[row(s)][row(t)];
}

std::vector<BodyPair> brute_force(const std::vector<Body>& bodies, bool is_solid_only) {
  std::vector<BodyPair> pairs;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const Body &s = bodies[i], &t = bodies[j];
      const bool is_sensed = s.role == Role::Sensor || t.role == Role::Sensor;
      if (!are_of_interest(s, t) || (is_solid_only && is_sensed)) continue;
      if (intersects({s.shape, s.pose}, {t.shape, t.pose})) pairs.push_back({s.id, t.id});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <typename Range>
std::vector<BodyPair> list(const Range& range) {
  return {range.begin(), range.end()};
}

Body random_body(RandomSource& source) {
  const auto kind = tests::kOwnKinds[static_cast<std::size_t>(source.integer(0, 8))];
  return {{},
          tests::random_shape(kind == ShapeKind::HalfSpace ? ShapeKind::Box : kind, 0.8, source),
          tests::random_pose(2, source),
          static_cast<BodyKind>(source.integer(0, 2)),
          source.uniform(0, 1) < 0.4 ? Role::Sensor : Role::Solid};
}

/// One of them moves, changes its role, its motion or its shape.
void change(Body& body, World& world, RandomSource& source) {
  const Body next = random_body(source);
  switch (static_cast<int>(source.integer(0, 4))) {
    case 0:
      body.role = next.role;
      return world.set_role(body.id, body.role);
    case 1:
      body.kind = next.kind;
      return world.set_kind(body.id, body.kind);
    case 2:
      body.shape = next.shape;
      return world.set_shape(body.id, body.shape);
    default:
      body.pose.translation() += source.vector(-0.1, 0.1);
      return world.move(body.id, body.pose);
  }
}

TEST(Sensors, EqualBruteForceOverRandomHistories) {
  RandomSource source(1);
  World world;
  std::vector<Body> bodies;
  for (int i = 0; i < 30; ++i) {
    Body body = random_body(source);
    body.id = world.add({body.shape, body.pose}, {.kind = body.kind, .role = body.role});
    EXPECT_EQ(world.role(body.id), body.role);
    bodies.push_back(body);
  }
  std::vector<BodyPair> before;
  std::size_t sensed = 0;
  for (int frame = 0; frame < 150; ++frame) {
    const WorldUpdate update = world.update();
    const std::vector<BodyPair> now = brute_force(bodies, false);
    const std::vector<BodyPair> solid = brute_force(bodies, true);
    ASSERT_EQ(world.pairs(), now) << frame;
    std::vector<BodyPair> begun, ended;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(),
                        std::back_inserter(begun));
    std::set_difference(before.begin(), before.end(), now.begin(), now.end(),
                        std::back_inserter(ended));
    EXPECT_EQ(list(update.begun), begun);
    EXPECT_EQ(list(update.ended), ended);
    std::vector<BodyPair> moved_solid, with_contacts, all_with_contacts;
    std::set_intersection(update.moved.begin(), update.moved.end(), solid.begin(), solid.end(),
                          std::back_inserter(moved_solid));
    for (const BodyContact& contact : update.contacts)
      with_contacts.push_back(contact.pair);
    EXPECT_EQ(with_contacts, moved_solid);
    EXPECT_EQ(update.work.contacts_found + update.work.contacts_skipped, update.moved.size());
    for (const BodyContact& contact : world.contacts())
      all_with_contacts.push_back(contact.pair);
    EXPECT_EQ(all_with_contacts, solid);
    sensed += now.size() - solid.size();
    before = now;
    for (int i = 0; i < 4; ++i) {
      const double count = static_cast<double>(bodies.size());
      change(bodies[static_cast<std::size_t>(source.uniform(0, count))], world, source);
    }
    ASSERT_FALSE(HasFailure()) << frame;
  }
  EXPECT_GT(sensed, 300u);
}

/// A pair that is known to be apart by far, until one of the two is another.
TEST(SetShape, VoidsWhatWasKnownOfGaps) {
  World world;
  const BodyId drum = world.add({Cylinder{1, 1}, at(0, 0, 0)});
  const BodyId cone = world.add({Cone{0.5, 0.5}, at(1.3, 1.3, 0)});
  std::uint64_t skipped = 0;
  for (int i = 0; i < 10; ++i) {
    world.move(cone, at(1.3, 1.3, 1e-3 * i));
    skipped += world.update().work.pairs_apart;
  }
  EXPECT_GT(skipped, 5u);
  world.set_shape(drum, Cylinder{1.5, 1});
  EXPECT_EQ(world.update().begun.size(), 1u);
  world.set_shape(drum, Cylinder{1, 1});
  EXPECT_EQ(world.update().ended.size(), 1u);
  EXPECT_EQ(world.update().work.shape_tests, 0u);
  const double nan = std::nan("");
  EXPECT_THROW(world.set_shape(drum, Cylinder{nan, 1}), InputError);
  EXPECT_THROW(world.set_shape(drum, std::shared_ptr<const BodyShape>()), InputError);
  world.remove(drum);
  EXPECT_THROW(world.set_shape(drum, Cylinder{1, 1}), StaleIdError);
}

/// A mesh that breathes, and a ball beside it.
TEST(SetShape, ADeformingMeshIsANewOneInEachStep) {
  World world;
  const Shape ball = Sphere{{0, 0, 0}, 0.5};
  world.add({ball, at(1.6, 0, 0)}, {.kind = BodyKind::Static});
  const BodyId body = world.add({tests::make_sphere(1, 8, 12), at(0, 0, 0)});
  int touching = 0;
  for (int i = 0; i < 40; ++i) {
    const Shape mesh = tests::make_sphere(1 + 0.2 * std::sin(0.3 * i), 8, 12);
    world.set_shape(body, mesh);
    world.update();
    const bool touches = intersects({mesh, at(0, 0, 0)}, {ball, at(1.6, 0, 0)});
    ASSERT_EQ(world.pairs().size(), touches ? 1u : 0u) << i;
    ASSERT_EQ(world.cast_ray({{0, 0.1, 0}, {-1, 0.01, 0}})->hit.distance,
              cast_ray({mesh, at(0, 0, 0)}, Ray{{0, 0.1, 0}, {-1, 0.01, 0}})->distance);
    touching += touches;
  }
  EXPECT_GT(touching, 5);
  EXPECT_LT(touching, 35);
}

TEST(Sensors, QueriesMayLeaveThemOut) {
  World world;
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const BodyId zone = world.add({ball, at(3, 0, 0)}, {.role = Role::Sensor});
  const BodyId wall = world.add({ball, at(6, 0, 0)}, {.kind = BodyKind::Static});
  const Ray ray{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(world.cast_ray(ray)->id, zone);
  EXPECT_EQ(world.cast_ray(ray, {.role = Role::Solid})->id, wall);
  EXPECT_EQ(world.cast_ray_all(ray, {.role = Role::Sensor}).size(), 1u);
  EXPECT_EQ(world.find_within({ball, at(0, 0, 0)}, 9).size(), 2u);
  EXPECT_EQ(world.find_closest({ball, at(0, 0, 0)}, {.role = Role::Solid})->id, wall);
  EXPECT_TRUE(world.find_touching({ball, at(3, 0, 0)}, {.role = Role::Solid}).empty());
}

}  // namespace
}  // namespace graze
