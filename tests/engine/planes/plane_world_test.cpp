// Planes as bodies, in cases and in scenes.

#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;

TEST(PlaneBodies, AWorldSaysWhatAskingEachPairSays) {
  RandomSource source(9);
  World world;
  const Shape wall = Plane{{0.25, 0, 1}, 0};
  const BodyId of_wall = world.add(PlacedShape{wall}, {.kind = BodyKind::Static});
  struct Moved {
    BodyId id;
    Shape shape;
    Pose pose;
  };
  std::vector<Moved> bodies;
  for (int i = 0; i < 60; ++i) {
    const auto kind = static_cast<ShapeKind>(i % static_cast<int>(ShapeKind::HalfSpace));
    const Shape shape = tests::random_shape(kind, 0.5, source);
    const Pose pose = tests::random_pose(3, source);
    bodies.push_back(
        {world.add(PlacedShape{shape, pose}, {.kind = BodyKind::Dynamic}), shape, pose});
  }
  std::size_t touching = 0;
  for (int step = 0; step < 20 && !HasFailure(); ++step) {
    world.update();
    std::vector<BodyId> wanted;
    for (const Moved& body : bodies) {
      const bool do_touch = intersects({body.shape, body.pose}, wall);
      if (do_touch) wanted.push_back(body.id);
      const auto pairs = world.pairs();
      const bool is_listed = std::any_of(pairs.begin(), pairs.end(), [&](const BodyPair& pair) {
        return pair == BodyPair{of_wall, body.id};
      });
      EXPECT_EQ(is_listed, do_touch);
    }
    touching += wanted.size();
    std::vector<BodyId> found = world.find_touching(wall);
    std::erase(found, of_wall);
    EXPECT_EQ(found, wanted);
    for (Moved& body : bodies) {
      body.pose.translation() += source.vector(-0.2, 0.2);
      world.move(body.id, body.pose);
    }
  }
  EXPECT_GT(touching, 50u);
}

TEST(PlaneBodies, ASweptBodyDoesNotPassOneFromBelow) {
  World world;
  const BodyId wall = world.add(PlacedShape{Plane{{0, 0, 1}, 0}}, {.kind = BodyKind::Static});
  const Shape ball = Sphere{{0, 0, 0}, 0.1};
  const BodyId id = world.add(PlacedShape{ball, at(0, 0, -3)},
                              {.kind = BodyKind::Dynamic, .detection = Detection::Continuous});
  world.update();
  world.move(id, at(0, 0, 7));
  const WorldUpdate update = world.update();
  EXPECT_TRUE(world.pairs().empty());
  ASSERT_EQ(update.first_contacts.size(), 1u);
  EXPECT_EQ(update.first_contacts[0].pair, (BodyPair{wall, id}));
  EXPECT_NEAR(update.first_contacts[0].contact.low, 0.29, 1e-5);
}

TEST(PlaneBodies, PartsMeetThemAndNoneIsOne) {
  Compound compound;
  compound.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 2)});
  compound.add({Sphere{{0, 0, 0}, 1}, at(0, 0, -2)});
  try {
    compound.add(Shape(Plane{{0, 0, 1}, 0}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "part: a plane is a body of its own, and no part of a compound");
  }
  World world;
  world.add({share(compound), Pose::Identity()}, {.kind = BodyKind::Dynamic});
  const Shape wall = Plane{{0, 0, 1}, 0};
  EXPECT_TRUE(world.find_touching(wall).empty());
  EXPECT_EQ(world.find_touching({wall, at(0, 0, 1)}).size(), 1u);
  const auto closest = world.find_closest({wall, at(0, 0, 0.75)});
  ASSERT_TRUE(closest);
  EXPECT_EQ(closest->distance.distance, 0.25);
}

TEST(PlaneBodies, CasesAndScenesHaveThem) {
  const Shape wall = Plane{{0, 0, 4}, 4};
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const bool says = intersects(wall, {ball, at(0, 1, 1)});
  const Case query =
      to_case(CaseShape(CaseBody(wall, Pose::Identity())), CaseBody(ball, at(0, 1, 1)), says);
  const Case back = parse_case(to_json(query), "memory");
  EXPECT_EQ(to_json(back), to_json(query));
  EXPECT_EQ(answer_case(back).says, says);
  const auto* plane = std::get<CaseBody>(back.a).shape.as<Plane>();
  ASSERT_NE(plane, nullptr);
  EXPECT_EQ(plane->normal, wall.as<Plane>()->normal);
  EXPECT_EQ(plane->offset, 1);
  const Scene scene = parse_scene(R"({"graze_scene": 1,
      "shapes": [{"name": "wall", "plane": {"normal": [0, 0, 2], "offset": 3}}],
      "bodies": [{"name": "w", "shape": "wall"}]})",
                                  "scene");
  ASSERT_EQ(scene.shapes.size(), 1u);
  EXPECT_EQ(scene.shapes[0].shape.as<Plane>()->offset, 1.5);
}

}  // namespace
}  // namespace graze
