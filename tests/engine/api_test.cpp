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
