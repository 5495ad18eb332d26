// The README's first page, as a program that must compile and be right.

#include <graze/graze.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <type_traits>
#include <vector>

namespace {

const std::string kMeshes = GRAZE_DATA_DIR "/meshes/";

TEST(Api, TheReadmesFirstPage) {
  graze::Mesh bolt = graze::load_mesh(kMeshes + "bolt.obj");
  graze::Mesh nut = graze::load_mesh(kMeshes + "nut.stl");
  graze::Pose pose = graze::Pose::Identity();
  pose.translation().z() = 0.002;

  graze::Work work;
  EXPECT_TRUE(graze::intersects({bolt}, {nut, pose}, &work));
  EXPECT_EQ(work.trees_built, 2u);
  EXPECT_FALSE(graze::find_triangle_pairs({bolt}, {nut, pose}).empty());
  EXPECT_EQ(graze::find_triangle_pairs({bolt}, {nut, pose}, {.limit = 3}).size(), 3u);

  graze::Aabb box{{0, 0, 0}, {0.01, 0.01, 0.01}};
  EXPECT_TRUE(graze::intersects({nut, pose}, box));
  EXPECT_FALSE(graze::find_triangles({nut, pose}, box).empty());
  EXPECT_TRUE(graze::intersects({nut}, graze::Obb{pose, {0.01, 0.01, 0.01}}));

  EXPECT_FALSE(graze::self_intersects(bolt));
  EXPECT_TRUE(graze::find_self_pairs(bolt).empty());
}

TEST(Api, TheReadmesManyPosesAndMotions) {
  graze::Mesh bolt = graze::load_mesh(kMeshes + "bolt.obj");
  graze::Mesh nut = graze::load_mesh(kMeshes + "nut.stl");
  graze::prepare(bolt);
  std::vector<graze::Pose> poses = graze::load_poses(GRAZE_DATA_DIR "/poses/bolt-nut.turning.txt");
  const std::vector<bool> hits = graze::intersects({bolt}, {nut, poses});
  EXPECT_EQ(hits, std::vector<bool>(poses.size(), false));
  graze::PairMemory memory;
  for (const graze::Pose& pose : poses)
    EXPECT_FALSE(graze::intersects({bolt}, {nut, pose}, memory));
}

/// Overwrites the part of the stack in which temporaries of the caller's last call were.
double overwritten(int depth) {
  volatile double rubbish[64];
  for (volatile double& number : rubbish)
    number = -1e300;
  return depth == 0 ? rubbish[7] : overwritten(depth - 1) + rubbish[depth];
}

graze::PlacedShapeView kept_view() {
  return {graze::Box{{1, 2, 3}}, graze::Pose(Eigen::Translation3d(4, 5, 6))};
}

TEST(Api, ViewsOfShapesHoldWhatHasNoName) {
  const graze::PlacedShapeView kept = kept_view();
  const graze::PlacedShapeView copy = kept;
  const graze::PlacedShapeView of_placed = graze::PlacedShape{kept.shape, kept.pose};
  const graze::PlacedShapeView alone = graze::Shape(graze::Box{{1, 2, 3}});
  const graze::Pose half(Eigen::Translation3d(2, 2.5, 3));
  const graze::Shape box(graze::Box{{1, 2, 3}});
  const graze::PlacedShapeView of_product(box, half * half),
      of_both(graze::Box{{1, 2, 3}}, half * half);
  const graze::PlacedShapeView in_own_frame(box, graze::Pose::Identity());
  EXPECT_LT(overwritten(20), 0);
  for (const graze::PlacedShapeView* view : {&kept, &copy, &of_placed, &of_product, &of_both}) {
    EXPECT_EQ(view->shape, graze::Shape(graze::Box{{1, 2, 3}}));
    EXPECT_EQ(view->pose.translation(), Eigen::Vector3d(4, 5, 6));
  }
  EXPECT_EQ(alone.shape, kept.shape);
  EXPECT_EQ(alone.pose.translation(), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(in_own_frame.pose.translation(), Eigen::Vector3d(0, 0, 0));
  const graze::Shape named = graze::Sphere{{0, 0, 0}, 1};
  const graze::Pose pose = graze::Pose::Identity();
  const graze::PlacedShapeView refers{named, pose};
  EXPECT_EQ(&refers.shape, &named);
  EXPECT_EQ(&refers.pose, &pose);
}

// A view is made once: nothing that it refers to can be replaced by another.
static_assert(std::is_copy_constructible_v<graze::PlacedShapeView>);
static_assert(!std::is_assignable_v<graze::PlacedShapeView&, graze::PlacedShapeView>);

// What moves goes in one braced argument, meshes and shapes alike.
template <typename... Arguments>
concept AreAskedForFirstContact = requires(Arguments... arguments) {
  graze::first_contact(arguments...);
};
static_assert(AreAskedForFirstContact<graze::MeshInMotion, graze::MeshInMotion>);
static_assert(AreAskedForFirstContact<graze::MeshInMotion, graze::MeshInMotions>);
static_assert(AreAskedForFirstContact<graze::ShapeInMotion, graze::ShapeInMotion>);
static_assert(
    !AreAskedForFirstContact<graze::Mesh, graze::RigidMotion, graze::Mesh, graze::RigidMotion>);

TEST(Api, WhatMovesIsGivenAsWhatIsPlaced) {
  const graze::Mesh nut = graze::load_mesh(kMeshes + "nut.stl");
  const graze::RigidMotion rest(graze::Pose::Identity());
  const graze::RigidMotion far(graze::Pose(Eigen::Translation3d(1, 0, 0)), {.shift = {1, 0, 0}});
  const std::vector<graze::RigidMotion> motions{far, rest};
  EXPECT_TRUE(graze::is_free({nut, rest}, {nut, far}));
  EXPECT_EQ(graze::is_free({nut, rest}, {nut, motions}), (std::vector<bool>{true, false}));
  const graze::Sphere ball{{0, 0, 0}, 0.1};
  EXPECT_TRUE(graze::is_free({ball, rest}, {nut, far}));
  graze::World world;
  const graze::BodyId body = world.add({nut});
  EXPECT_EQ(world.cast({ball, rest})->id, body);
  EXPECT_TRUE(world.cast_all({ball, far}).empty());
}

TEST(Api, TheReadmesManyBodies) {
  graze::Mesh bolt = graze::load_mesh(kMeshes + "bolt.obj");
  graze::Pose floor_pose = graze::Pose::Identity();
  floor_pose.translation().z() = -0.1;
  graze::Pose start_pose = graze::Pose::Identity();
  start_pose.translation().z() = 1;
  graze::World world;
  graze::BodyId floor =
      world.add({graze::Box{{10, 10, 0.1}}, floor_pose}, {.kind = graze::BodyKind::Static});
  graze::BodyId body = world.add({bolt, start_pose});
  EXPECT_TRUE(world.update().begun.empty());
  world.move(body, graze::Pose::Identity());
  const graze::WorldUpdate down = world.update();
  ASSERT_EQ(down.begun.size(), 1u);
  EXPECT_EQ(down.begun[0].a, floor);
  EXPECT_EQ(down.contacts.size(), 1u);
  world.move(body, start_pose);
  EXPECT_EQ(world.update().ended.size(), 1u);

  graze::BroadPhase boxes;
  graze::Aabb box{{0, 0, 0}, {0.01, 0.01, 0.01}};
  graze::BoxId crate = boxes.add(box);
  boxes.add(box);
  boxes.update();
  EXPECT_EQ(boxes.pairs().size(), 1u);
  EXPECT_TRUE(boxes.contains(crate));
}

TEST(Api, IsometriesOfEigenArePoses) {
  const std::vector<Eigen::Vector3d> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Eigen::Vector3i> triangles{{0, 1, 2}};
  const graze::Mesh mesh(vertices, triangles);
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  EXPECT_TRUE(graze::intersects({mesh}, {mesh, moved}));
  moved.translation().z() = 1;
  EXPECT_FALSE(graze::intersects({mesh}, {mesh, moved}));
}

// The layout of public types must not depend on the SIMD flags of a program.
TEST(Api, NoPublicTypeIsOverAligned) {
  EXPECT_EQ(alignof(graze::Pose), alignof(double));
  EXPECT_EQ(alignof(graze::Obb), alignof(double));
  EXPECT_EQ(alignof(graze::Aabb), alignof(double));
  EXPECT_EQ(alignof(graze::Triangle), alignof(double));
  EXPECT_EQ(alignof(graze::PlacedMesh), alignof(double));
  EXPECT_EQ(alignof(graze::PlacedMeshView), alignof(double));
  EXPECT_EQ(alignof(graze::PlacedShape), alignof(double));
}

}  // namespace
