// Worlds on a height field beside worlds on its mesh, and beside asking each pair.

#include <graze/engine/print.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/world.h>
#include <graze/engine/world/world_drawing.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <tuple>
#include <utility>
#include <vector>

#include "tests/engine/height_fields/random_fields.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::FieldTwins;
using tests::Ground;
using tests::random_shape;

FieldTwins ground(std::uint64_t seed) {
  RandomSource source(seed);
  tests::FieldParts parts;
  parts.columns = parts.rows = 40;
  for (std::uint32_t i = 0; i < 40 * 40; ++i)
    parts.heights.push_back(static_cast<float>(source.uniform(0, 0.7)));
  parts.holes.assign(39 * 39, 0);
  for (std::uint8_t& hole : parts.holes)
    hole = source.integer(0, 20) == 0;
  parts.holes[0] = 0;
  parts.settings.spacing_x = parts.settings.spacing_y = 0.5;
  return FieldTwins(parts.field());
}

/// Bodies of all convex kinds that go about on a ground, which is the body of index 0.
class Walk {
 public:
  Walk(const Shape& on, const WorldSettings& settings, bool is_swept)
      : world_(settings), source_(31) {
    world_.add({on}, {.kind = BodyKind::Static, .margin = 0.01});
    for (int i = 0; i < 60; ++i) {
      const ShapeKind kind = kShapeKinds[static_cast<std::size_t>(i % 7)];
      Pose pose = tests::random_pose(0, source_);
      pose.translation() =
          Eigen::Vector3d{source_.uniform(0, 20), source_.uniform(0, 20), source_.uniform(0, 2)};
      const bool swept = is_swept && i % 3 == 0;
      ids_.push_back(
          world_.add({random_shape(kind, 0.5, source_), pose},
                     {.detection = swept ? Detection::Continuous : Detection::Discrete}));
    }
  }

  WorldUpdate step() {
    for (const BodyId id : ids_) {
      if (source_.integer(0, 2) == 0) continue;
      Pose pose = world_.pose(id);
      pose.translation() += source_.vector(-0.4, 0.4);
      if (source_.integer(0, 5) == 0) pose.translation().z() = source_.uniform(0, 3);
      world_.move(id, pose);
    }
    return world_.update();
  }
  World& world() { return world_; }

 private:
  World world_;
  RandomSource source_;
  std::vector<BodyId> ids_;
};

template <typename List>
std::vector<typename List::value_type> copy_of(const List& list) {
  return {list.begin(), list.end()};
}

/// The contacts with the numbers of the field, which is pair.a.
std::vector<BodyContact> numbered(std::span<const BodyContact> contacts, const FieldTwins& twins) {
  std::vector<BodyContact> all(contacts.begin(), contacts.end());
  for (BodyContact& contact : all) {
    if (contact.pair.a.index == 0) contact.manifold = twins.numbered(contact.manifold, true);
  }
  return all;
}

/// First contacts, but for which of several triangles one is with that are met at one time.
std::vector<std::tuple<BodyPair, double, bool>> times_of(const WorldUpdate& update) {
  std::vector<std::tuple<BodyPair, double, bool>> times;
  for (const BodyFirstContact& each : update.first_contacts)
    times.emplace_back(each.pair, each.contact.low, each.is_at_start);
  return times;
}

TEST(HeightFieldWorld, SaysWhatAWorldOnItsMeshSays) {
  const FieldTwins twins = ground(30);
  for (const bool is_swept : {false, true}) {
    Walk on_field(twins.field(), {}, is_swept), on_mesh(twins.mesh(), {}, is_swept);
    std::size_t contacts = 0, ways = 0;
    for (int step = 0; step < 60; ++step) {
      const WorldUpdate of_field = on_field.step(), of_mesh = on_mesh.step();
      EXPECT_EQ(copy_of(of_field.begun), copy_of(of_mesh.begun)) << step;
      EXPECT_EQ(copy_of(of_field.ended), copy_of(of_mesh.ended));
      EXPECT_EQ(copy_of(of_field.moved), copy_of(of_mesh.moved));
      EXPECT_EQ(copy_of(of_field.begun_near), copy_of(of_mesh.begun_near));
      EXPECT_EQ(copy_of(of_field.contacts), numbered(of_mesh.contacts, twins)) << step;
      EXPECT_EQ(times_of(of_field), times_of(of_mesh)) << step;
      contacts += of_field.contacts.size();
      ways += of_field.first_contacts.size();
    }
    EXPECT_GT(contacts, 500u);
    EXPECT_EQ(ways > 100, is_swept);
    EXPECT_EQ(on_field.world().contacts(), numbered(on_mesh.world().contacts(), twins));
  }
}

TEST(HeightFieldWorld, QueriesOfTheWorldAreThoseOfAMesh) {
  const FieldTwins twins = ground(32);
  Walk on_field(twins.field(), {}, false), on_mesh(twins.mesh(), {}, false);
  on_field.step(), on_mesh.step();
  RandomSource source(33);
  int hits = 0;
  for (int n = 0; n < 200; ++n) {
    const Shape shape = random_shape(kShapeKinds[static_cast<std::size_t>(n % 7)], 0.5, source);
    Pose pose = tests::random_pose(0, source);
    pose.translation() =
        Eigen::Vector3d{source.uniform(-1, 21), source.uniform(-1, 21), source.uniform(0, 3)};
    EXPECT_EQ(on_field.world().find_touching({shape, pose}),
              on_mesh.world().find_touching({shape, pose}));
    const auto near = on_field.world().find_closest({shape, pose});
    const auto wanted = on_mesh.world().find_closest({shape, pose});
    ASSERT_TRUE(near && wanted);
    EXPECT_EQ(near->id, wanted->id);
    EXPECT_EQ(near->distance.distance, wanted->distance.distance);
    const RigidMotion motion(pose, {.centre = pose.translation(), .shift = source.vector(-3, 3)});
    EXPECT_EQ(on_field.world().cast({shape, motion}), on_mesh.world().cast({shape, motion}));
    const Ray ray{pose.translation(), source.vector(-1, 1)};
    const auto hit = on_field.world().cast_ray(ray);
    const auto on = on_mesh.world().cast_ray(ray);
    ASSERT_EQ(hit.has_value(), on.has_value());
    if (hit) {
      ++hits;
      EXPECT_EQ(hit->id, on->id);
      EXPECT_EQ(hit->hit.distance, on->hit.distance);
      if (hit->id.index != 0) continue;
      EXPECT_EQ(hit->hit.triangle, twins.number(on->hit.triangle));
    }
  }
  EXPECT_GT(hits, 40);
}

TEST(HeightFieldWorld, ThreadsChangeNothing) {
  const FieldTwins twins = ground(34);
  Walk alone(twins.field(), {.threads = 1}, true);
  std::vector<Walk> shared;
  for (const int threads : {2, 4, 8})
    shared.emplace_back(twins.field(), WorldSettings{.threads = threads}, true);
  for (int step = 0; step < 30; ++step) {
    const WorldUpdate one = alone.step();
    for (Walk& walk : shared) {
      const WorldUpdate other = walk.step();
      EXPECT_EQ(copy_of(one.contacts), copy_of(other.contacts)) << step;
      EXPECT_EQ(copy_of(one.begun), copy_of(other.begun));
      EXPECT_EQ(copy_of(one.first_contacts), copy_of(other.first_contacts));
      EXPECT_EQ(one.work, other.work) << step;
    }
  }
}

TEST(HeightFieldWorld, ACraterIsAnotherShapeOfTheBody) {
  tests::FieldParts parts;
  parts.columns = parts.rows = 20;
  parts.heights.assign(400, 1);
  const HeightField before = parts.field();
  World world;
  const BodyId terrain = world.add({before}, {.kind = BodyKind::Static});
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d{9.5, 9.5, 1.2};
  world.add({Sphere{{0, 0, 0}, 0.5}, pose});
  EXPECT_EQ(world.update().begun.size(), 1u);
  const std::vector<float> deep(16, -3);
  world.set_shape(terrain, before.with_heights({8, 8, 4, 4}, std::span<const float>(deep)));
  EXPECT_EQ(world.update().ended.size(), 1u);
}

TEST(HeightFieldWorld, MayBePartOfACompoundAndADynamicBody) {
  const FieldTwins twins = ground(35);
  World on_field, on_mesh;
  for (const auto& [world, shape] :
       {std::pair(&on_field, &twins.field()), std::pair(&on_mesh, &twins.mesh())}) {
    Compound compound;
    compound.add({*shape});
    Pose turned = Pose::Identity();
    turned.linear() = Eigen::AngleAxisd(0.3, Vector3d::UnitX()).toRotationMatrix();
    turned.translation() = Eigen::Vector3d{0, 0, -4};
    compound.add({*shape, turned});
    world->add({share(compound), Pose::Identity()});
    world->add({HalfSpace{{0, 0, 1}, 0.1}}, {.kind = BodyKind::Static});
    for (int i = 0; i < 20; ++i) {
      Pose pose = Pose::Identity();
      pose.translation() = Eigen::Vector3d{1.0 * i, 19 - 0.7 * i, 0.5};
      world->add({Box{{0.4, 0.3, 0.5}}, pose});
    }
  }
  const WorldUpdate of_field = on_field.update(), of_mesh = on_mesh.update();
  EXPECT_EQ(copy_of(of_field.begun), copy_of(of_mesh.begun));
  ASSERT_EQ(of_field.contacts.size(), of_mesh.contacts.size());
  EXPECT_GT(of_field.contacts.size(), 15u);
  for (std::size_t i = 0; i < of_field.contacts.size(); ++i) {
    const Manifold& s = of_field.contacts[i].manifold;
    const Manifold& t = of_mesh.contacts[i].manifold;
    ASSERT_EQ(s.size(), t.size());
    for (std::size_t k = 0; k < s.size(); ++k) {
      EXPECT_EQ(s[k].point, t[k].point);
      EXPECT_EQ(s[k].depth, t[k].depth);
    }
  }
}

class Lines final : public WorldDrawer {
 public:
  void line(const DrawnLine& line) override { lines.emplace_back(line.from, line.to); }
  std::vector<std::pair<Vector3d, Vector3d>> lines;
};

TEST(HeightFieldWorld, IsDrawnAsItsMeshIs) {
  RandomSource source(36);
  for (int n = 0; n < 20; ++n) {
    const FieldTwins twins(tests::random_parts(Ground::Rough, source).field());
    Lines of_field, of_mesh;
    draw({twins.field()}, of_field);
    draw({twins.mesh()}, of_mesh);
    EXPECT_EQ(of_field.lines, of_mesh.lines);
  }
}

}  // namespace
}  // namespace graze
