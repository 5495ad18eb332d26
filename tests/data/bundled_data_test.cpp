// The claims of data/README.md about the bundled meshes and poses.

#include <gtest/gtest.h>

#include <graze/graze.h>
#include <algorithm>
#include <string>

namespace graze {
namespace {

const std::filesystem::path kData = GRAZE_DATA_DIR;

Mesh bundled_mesh(const std::string& name) {
  return load_mesh(kData / "meshes" / name);
}

struct Solid {
  const char* file;
  std::size_t triangles;
  long euler;  // vertices - edges + triangles: 2 for a ball, 0 for a ring
};

class BundledMesh : public testing::TestWithParam<Solid> {};

TEST_P(BundledMesh, IsOneCleanClosedSolid) {
  const Mesh mesh = bundled_mesh(GetParam().file);
  const Topology& topology = mesh.topology();
  EXPECT_EQ(mesh.triangles().size(), GetParam().triangles);
  EXPECT_TRUE(topology.is_closed);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.degenerate_triangles, 0u);
  EXPECT_EQ(topology.duplicate_triangles, 0u);
  const long edges = static_cast<long>(mesh.triangles().size()) * 3 / 2;
  EXPECT_EQ(static_cast<long>(topology.welded_vertices) - edges +
                static_cast<long>(mesh.triangles().size()),
            GetParam().euler);
}

TEST_P(BundledMesh, DoesNotCrossItself) {
  EXPECT_FALSE(self_intersects(bundled_mesh(GetParam().file)));
}

TEST_P(BundledMesh, FacesOutwards) {
  const Mesh mesh = bundled_mesh(GetParam().file);
  double volume = 0;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    volume += t.a.dot(t.b.cross(t.c)) / 6;
  }
  EXPECT_GT(volume, 0);
}

INSTANTIATE_TEST_SUITE_P(All, BundledMesh,
                         testing::Values(Solid{"bolt.obj", 15928, 2}, Solid{"nut.stl", 9228, 0},
                                         Solid{"gear.ply", 7192, 0}, Solid{"pinion.off", 5510, 0}),
                         [](const auto& test) {
                           const std::string file = test.param.file;
                           return file.substr(0, file.find('.'));
                         });

// Pose i of a file is clear below `first_hit` and hits from there on.
struct PoseFile {
  const char* file;
  std::size_t poses;
  std::size_t first_hit;
};

class BundledPoses : public testing::TestWithParam<PoseFile> {};

TEST_P(BundledPoses, AreClearThenHit) {
  const std::string file = GetParam().file;
  const bool is_thread = file.starts_with("bolt-nut.");
  const Mesh mesh_a = bundled_mesh(is_thread ? "bolt.obj" : "gear.ply");
  const Mesh mesh_b = bundled_mesh(is_thread ? "nut.stl" : "pinion.off");
  const std::vector<Pose> poses = load_poses(kData / "poses" / file);
  ASSERT_EQ(poses.size(), GetParam().poses);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(intersects({mesh_a}, {mesh_b, poses[i]}), i >= GetParam().first_hit) << "pose " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, BundledPoses,
                         testing::Values(PoseFile{"bolt-nut.turning.txt", 72, 72},
                                         PoseFile{"bolt-nut.cross.txt", 25, 6},
                                         PoseFile{"bolt-nut.deep.txt", 6, 0},
                                         PoseFile{"bolt-nut.apart.txt", 6, 6},
                                         PoseFile{"gear-pinion.mesh.txt", 60, 60},
                                         PoseFile{"gear-pinion.tight.txt", 26, 11},
                                         PoseFile{"gear-pinion.deep.txt", 4, 0},
                                         PoseFile{"gear-pinion.apart.txt", 4, 4}),
                         [](const auto& test) {
                           std::string name = test.param.file;
                           name.resize(name.size() - 4);
                           std::ranges::replace_if(
                               name, [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

// What the README says: in the thread's clearance, the rounded stage decides all candidates.
TEST(BundledParts, TheTurningNutNeedsNoExactArithmetic) {
  const Mesh bolt = bundled_mesh("bolt.obj");
  const Mesh nut = bundled_mesh("nut.stl");
  for (const Pose& pose : load_poses(kData / "poses/bolt-nut.turning.txt")) {
    Work work;
    intersects({bolt}, {nut, pose}, &work);
    EXPECT_GT(work.triangle_tests, 40000u);
    EXPECT_EQ(work.exact_tests, 0u);
  }
}

// Tilting the nut further presses more of the thread together.
TEST(BundledPosesOfTheCrossedNut, BindMoreAndMore) {
  const Mesh bolt = bundled_mesh("bolt.obj");
  const Mesh nut = bundled_mesh("nut.stl");
  std::size_t last = 0;
  for (const Pose& pose : load_poses(kData / "poses/bolt-nut.cross.txt")) {
    const std::size_t pairs = find_triangle_pairs({bolt}, {nut, pose}).size();
    EXPECT_GE(pairs, last);
    last = pairs;
  }
}

}  // namespace
}  // namespace graze
