// Where an error lies, as a program reads it.

#include <graze/graze.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "tests/files/temporary_directory.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

template <typename E, typename Call>
std::optional<ErrorPlace> place_of(Call&& call) {
  try {
    call();
  } catch (const E& error) {
    const Error copy = error;
    EXPECT_EQ(copy.place(), error.place());
    return error.place();
  }
  return std::nullopt;
}

class ErrorPlaces : public testing::Test {
 protected:
  std::string file(const char* name, const std::string& text) {
    const std::filesystem::path path = folder_.path(name);
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

 private:
  tests::TemporaryDirectory folder_;
};

TEST_F(ErrorPlaces, OfFilesAndTheirLines) {
  const std::string obj = file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 x 0\nf 1 2 3\n");
  EXPECT_EQ(place_of<MeshError>([&] { load_mesh(obj); }), (ErrorPlace{.file = obj, .line = 3}));
  const std::string none = file("none.off", "OFF\n0 0 0\n");
  EXPECT_EQ(place_of<MeshError>([&] { load_mesh(none); })->file, none);
  const std::string poses = file("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n\n1 0 0 0\n");
  EXPECT_EQ(place_of<PoseError>([&] { load_poses(poses); }),
            (ErrorPlace{.file = poses, .line = 3}));
  const std::string short_ply =
      file("short.ply",
           "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
           "property float y\nproperty float z\nelement face 0\n"
           "property list uchar int vertex_indices\nend_header\n1234");
  const auto place = place_of<MeshError>([&] { load_mesh(short_ply); });
  ASSERT_TRUE(place);
  EXPECT_EQ(place->file, short_ply);
  EXPECT_TRUE(place->byte.has_value());
  EXPECT_FALSE(place->line.has_value());
}

TEST_F(ErrorPlaces, OfElements) {
  const double nan = std::nan("");
  const std::vector<Eigen::Vector3d> good{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Eigen::Vector3d> bad = good;
  bad[2].y() = nan;
  const std::vector<TriangleIndices> triangles{{0, 1, 2}}, beyond{{0, 1, 2}, {0, 1, 4}};
  EXPECT_EQ(place_of<MeshError>([&] { Mesh(bad, triangles); }),
            (ErrorPlace{.element = "vertex", .index = 2}));
  EXPECT_EQ(place_of<MeshError>([&] { Mesh(good, beyond); }),
            (ErrorPlace{.element = "triangle", .index = 1}));
  EXPECT_EQ(place_of<InputError>([&] { ConvexHull hull(bad); }),
            (ErrorPlace{.element = "point", .index = 2}));
  EXPECT_EQ(place_of<InputError>([&] { bounding_aabb(std::span<const Eigen::Vector3d>(bad)); }),
            (ErrorPlace{.element = "point", .index = 2}));
  const Mesh box = tests::make_box({1, 1, 1});
  std::vector<Pose> poses(3, Pose::Identity());
  poses[1].matrix()(0, 0) = nan;
  EXPECT_EQ(place_of<PoseError>([&] {
              intersects({box}, {box, poses});
            }),
            (ErrorPlace{.element = "pose", .index = 1}));
  AabbList boxes;
  boxes.add({{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(place_of<InputError>([&] {
              boxes.add({{1, 0, 0}, {0, 0, 0}});
            }),
            (ErrorPlace{.element = "box", .index = 1}));
}

TEST_F(ErrorPlaces, OfBodiesAndBoxes) {
  World world;
  const BodyId a = world.add({Sphere{{0, 0, 0}, 1}});
  const BodyId b = world.add({Sphere{{0, 0, 0}, 1}, tests::at(5)});
  world.remove(b);
  EXPECT_EQ(place_of<StaleIdError>([&] { world.pose(b); }),
            (ErrorPlace{.element = "body", .index = b.index}));
  const std::vector<BodyId> ids{a, b};
  const std::vector<Pose> poses(2, Pose::Identity());
  EXPECT_EQ(place_of<StaleIdError>([&] { world.move(ids, poses); }),
            (ErrorPlace{.element = "element", .index = 1}));
  BroadPhase broad;
  const BoxId box = broad.add({{0, 0, 0}, {1, 1, 1}});
  broad.remove(box);
  EXPECT_EQ(place_of<StaleIdError>([&] { broad.box(box); }),
            (ErrorPlace{.element = "box", .index = box.index}));
}

TEST_F(ErrorPlaces, OfMovingThingsFieldsAndVoxels) {
  World world;
  const BodyId swept = world.add({Sphere{{0, 0, 0}, 1}}, {.detection = Detection::Continuous});
  world.update();
  EXPECT_EQ(place_of<InputError>([&] { world.move(swept, RigidMotion(tests::at(9))); }),
            (ErrorPlace{.element = "body", .index = swept.index}));
  EXPECT_EQ(place_of<InputError>([&] { world.exclude(swept, swept); }),
            (ErrorPlace{.element = "body", .index = swept.index}));
  const std::vector<float> heights{0, 0, 0, 0, HUGE_VALF, 0};
  EXPECT_EQ(place_of<InputError>([&] { HeightField(3, 2, heights); }),
            (ErrorPlace{.element = "height", .index = 4}));
  const VoxelGrid grid{{0, 0, 0}, 1, {2, 2, 2}};
  VoxelMap map(grid);
  EXPECT_EQ(place_of<InputError>([&] {
              map.add_block({2, 0, 0}, {2, 0, 0});
            }),
            (ErrorPlace{.element = "voxel"}));
  EXPECT_EQ(place_of<InputError>([&] { static_cast<void>(ContactTracker().ids(3)); }),
            (ErrorPlace{.element = "manifold", .index = 3}));
}

TEST_F(ErrorPlaces, OfPathsInABatchAndSlabs) {
  const PointPath rests{{0, 0, 0}, {0, 0, 0}}, bad{{0, 0, 0}, {0, std::nan(""), 0}};
  const std::vector<PointPath> points{rests, bad};
  const std::vector<TrianglePath> triangles(2, TrianglePath{rests, rests, rests});
  std::vector<std::optional<FirstContact>> contacts(2);
  EXPECT_EQ(place_of<InputError>([&] { first_contacts(points, triangles, contacts); }),
            (ErrorPlace{.element = "point", .index = 1}));
  const std::vector<EdgePath> edges{{rests, rests}, {rests, rests}}, bad_edges{{rests, bad}};
  EXPECT_EQ(place_of<InputError>([&] {
              first_contacts({edges.data(), 1}, bad_edges, {contacts.data(), 1});
            }),
            (ErrorPlace{.element = "edge", .index = 0}));
  EXPECT_EQ(place_of<InputError>([&] { first_contact(bad, triangles[0]); }), ErrorPlace{});
  KDop<18> kdop{};
  kdop.max[7] = -1;
  EXPECT_EQ(place_of<InputError>([&] { intersects(kdop, KDop<18>{}); }),
            (ErrorPlace{.element = "slab", .index = 7}));
}

TEST_F(ErrorPlaces, NothingIsKnownOfTheRest) {
  EXPECT_EQ(place_of<InputError>([] { check_ray({{0, 0, 0}, {0, 0, 0}}, "ray"); }), ErrorPlace{});
}

}  // namespace
}  // namespace graze
