// The claims of data/README.md about the bundled meshes and poses.

#include <gtest/gtest.h>

#include <graze/graze.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace graze {
namespace {

const std::filesystem::path kData = GRAZE_DATA_DIR;

Mesh bundled_mesh(const std::string& file) {
  return load_mesh(kData / "meshes" / file);
}

// The meshes of a file of poses, whose name begins with theirs.
Mesh mesh_of_poses(const std::string& name) {
  static const std::map<std::string, const char*> files = {
      {"bolt", "bolt.obj"},      {"nut", "nut.stl"},   {"gear", "gear.ply"},
      {"pinion", "pinion.off"},  {"link", "link.ply"}, {"rock", "rock.ply"},
      {"terrain", "terrain.ply"}};
  return bundled_mesh(files.at(name));
}

std::vector<Pose> bundled_poses(const std::string& file) {
  return load_poses(kData / "poses" / file);
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
                                         Solid{"gear.ply", 7192, 0}, Solid{"pinion.off", 5510, 0},
                                         Solid{"link.ply", 4608, 0}, Solid{"rock.ply", 15680, 2}),
                         [](const auto& test) {
                           const std::string file = test.param.file;
                           return file.substr(0, file.find('.'));
                         });

TEST(BundledTerrain, IsOneCleanOpenSheet) {
  const Mesh terrain = bundled_mesh("terrain.ply");
  const Topology& topology = terrain.topology();
  EXPECT_EQ(terrain.triangles().size(), 20000u);
  EXPECT_FALSE(topology.is_closed);
  EXPECT_EQ(topology.boundary_edges, 400u);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.degenerate_triangles, 0u);
  EXPECT_EQ(topology.duplicate_triangles, 0u);
  EXPECT_FALSE(self_intersects(terrain));
}

// Seen from above no triangle is turned over, and together they cover the square once: each point
// has one height.
TEST(BundledTerrain, HasOneHeightOverEachPoint) {
  const Mesh terrain = bundled_mesh("terrain.ply");
  double sum = 0;
  for (std::size_t i = 0; i < terrain.triangles().size(); ++i) {
    const Triangle t = terrain.triangle(i);
    const double area = (t.b - t.a).cross(t.c - t.a).z() / 2;
    EXPECT_GT(area, 0.1 * 0.1 * 0.1) << "triangle " << i;
    sum += area;
  }
  EXPECT_NEAR(sum, 100, 1e-9);
}

TEST(BundledTerrain, HasTheSizeOfThePage) {
  const Aabb bounds = bundled_mesh("terrain.ply").bounds();
  EXPECT_EQ(bounds.min.head<2>(), Eigen::Vector2d(-5, -5));
  EXPECT_EQ(bounds.max.head<2>(), Eigen::Vector2d(5, 5));
  EXPECT_NEAR(bounds.min.z(), -0.603, 5e-4);
  EXPECT_NEAR(bounds.max.z(), 0.908, 5e-4);
}

TEST(BundledRock, HasTheSizeOfThePage) {
  const Aabb bounds = bundled_mesh("rock.ply").bounds();
  const Eigen::Vector3d size = bounds.max - bounds.min;
  EXPECT_NEAR(size.x(), 0.300, 1e-12);
  EXPECT_NEAR(size.y(), 0.248, 5e-4);
  EXPECT_NEAR(size.z(), 0.200, 5e-4);
}

// Each triangle is seen from the origin from within, so that a ray leaves the rock once.
TEST(BundledRock, IsStarShaped) {
  const Mesh rock = bundled_mesh("rock.ply");
  for (std::size_t i = 0; i < rock.triangles().size(); ++i) {
    const Triangle t = rock.triangle(i);
    EXPECT_GT(t.a.dot(t.b.cross(t.c)), 0) << "triangle " << i;
  }
}

// From the segment that joins the bends' centres the wire's middle line is 7.2 mm away, and its
// surface is 3 mm from that line.
constexpr double kBend = 0.0072;
constexpr double kHalfLeg = 0.00505;

double distance_to_legs_middle(double x, double y) {
  return std::hypot(x - std::clamp(x, -kHalfLeg, kHalfLeg), y);
}

TEST(BundledLink, HasTheSizeOfThePage) {
  const Mesh link = bundled_mesh("link.ply");
  const Eigen::Vector3d size = link.bounds().max - link.bounds().min;
  EXPECT_LT((size - Eigen::Vector3d(0.0305, 0.0204, 0.006)).cwiseAbs().maxCoeff(), 1e-15);
  double opening = 1;
  for (const Eigen::Vector3d& v : link.vertices()) {
    EXPECT_NEAR(std::hypot(distance_to_legs_middle(v.x(), v.y()) - kBend, v.z()), 0.003, 1e-15);
    if (v.y() == 0) opening = std::min(opening, 2 * std::abs(v.x()));
  }
  EXPECT_NEAR(opening, 0.0185, 1e-15);
}

// How often the middle line of B's wire goes up through A's opening, less how often down.
int linking_number(const Pose& pose) {
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 720; ++i) {
    const double angle = std::numbers::pi * i / 360;
    const double x = std::copysign(kHalfLeg, std::cos(angle)) + kBend * std::cos(angle);
    line.push_back(pose * Eigen::Vector3d(x, kBend * std::sin(angle), 0));
  }
  int sum = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector3d& p = line[i];
    const Eigen::Vector3d& q = line[(i + 1) % line.size()];
    if ((p.z() < 0) == (q.z() < 0)) continue;
    const Eigen::Vector3d crossing = p + (q - p) * (p.z() / (p.z() - q.z()));
    if (distance_to_legs_middle(crossing.x(), crossing.y()) < kBend) sum += q.z() < 0 ? -1 : 1;
  }
  return sum;
}

TEST(BundledLink, PosesAreInterlockedUnlessApart) {
  for (const char* file : {"clear", "near", "touch", "deep"}) {
    for (const Pose& pose : bundled_poses("link-link." + std::string(file) + ".txt")) {
      EXPECT_EQ(std::abs(linking_number(pose)), 1) << file;
    }
  }
  for (const Pose& pose : bundled_poses("link-link.apart.txt"))
    EXPECT_EQ(linking_number(pose), 0);
}

// Pose i of a file is clear below `first_hit` and hits from there on.
struct PoseFile {
  const char* file;
  std::size_t poses;
  std::size_t first_hit;
};

constexpr PoseFile kPoseFiles[] = {
    {"bolt-nut.turning.txt", 72, 72},  {"bolt-nut.cross.txt", 25, 6},
    {"bolt-nut.deep.txt", 6, 0},       {"bolt-nut.apart.txt", 6, 6},
    {"bolt-nut.far.txt", 36, 36},      {"bolt-nut.near.txt", 36, 36},
    {"bolt-nut.touch.txt", 36, 0},     {"gear-pinion.mesh.txt", 60, 60},
    {"gear-pinion.tight.txt", 26, 11}, {"gear-pinion.deep.txt", 4, 0},
    {"gear-pinion.apart.txt", 4, 4},   {"gear-pinion.far.txt", 36, 36},
    {"gear-pinion.near.txt", 36, 36},  {"gear-pinion.touch.txt", 36, 0},
    {"link-link.clear.txt", 36, 36},   {"link-link.near.txt", 36, 36},
    {"link-link.touch.txt", 36, 0},    {"link-link.deep.txt", 36, 0},
    {"link-link.apart.txt", 36, 36},   {"rock-rock.far.txt", 36, 36},
    {"rock-rock.near.txt", 36, 36},    {"rock-rock.touch.txt", 36, 0},
    {"rock-rock.deep.txt", 36, 0},     {"terrain-rock.far.txt", 36, 36},
    {"terrain-rock.near.txt", 36, 36}, {"terrain-rock.touch.txt", 36, 0},
    {"terrain-rock.deep.txt", 36, 0},
};

class BundledPoses : public testing::TestWithParam<PoseFile> {};

TEST_P(BundledPoses, AreClearThenHit) {
  const std::string file = GetParam().file;
  const std::size_t dash = file.find('-');
  const Mesh mesh_a = mesh_of_poses(file.substr(0, dash));
  const Mesh mesh_b = mesh_of_poses(file.substr(dash + 1, file.find('.') - dash - 1));
  const std::vector<Pose> poses = bundled_poses(file);
  ASSERT_EQ(poses.size(), GetParam().poses);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(intersects({mesh_a}, {mesh_b, poses[i]}), i >= GetParam().first_hit) << "pose " << i;
  }
}

TEST_P(BundledPoses, AreRotationsUpToRounding) {
  for (const Pose& pose : bundled_poses(GetParam().file))
    EXPECT_LE(rotation_deviation(pose), 2e-15);
}

INSTANTIATE_TEST_SUITE_P(All, BundledPoses, testing::ValuesIn(kPoseFiles), [](const auto& test) {
  std::string name = test.param.file;
  name.resize(name.size() - 4);
  std::ranges::replace_if(
      name, [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
});

TEST(BundledPoseFiles, AreAllLookedAt) {
  for (const auto& entry : std::filesystem::directory_iterator(kData / "poses")) {
    const std::string file = entry.path().filename().string();
    EXPECT_TRUE(std::ranges::any_of(kPoseFiles, [&](const auto& f) { return f.file == file; }))
        << file;
  }
}

// 0.1, 1 and 5 percent of 0.3 m before the touch, in turn: a millionth of that less far it is
// clear, a millionth farther it touches.
TEST(BundledPosesOfTheFallingRock, StopAsFarFromTheGroundAsThePageSays) {
  const Mesh terrain = bundled_mesh("terrain.ply");
  const Mesh rock = bundled_mesh("rock.ply");
  const double drops[] = {0.0003, 0.003, 0.015};
  const std::vector<Pose> poses = bundled_poses("terrain-rock.near.txt");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Pose lower = poses[i];
    lower.translation().z() = poses[i].translation().z() - drops[i % 3] * (1 - 1e-6);
    EXPECT_FALSE(intersects({terrain}, {rock, lower})) << "pose " << i;
    lower.translation().z() = poses[i].translation().z() - drops[i % 3] * (1 + 1e-6);
    EXPECT_TRUE(intersects({terrain}, {rock, lower})) << "pose " << i;
  }
}

// What the README says: in the thread's clearance the stages in float and double decide everything.
TEST(BundledParts, TheTurningNutNeedsNoExactArithmetic) {
  const Mesh bolt = bundled_mesh("bolt.obj");
  const Mesh nut = bundled_mesh("nut.stl");
  for (const Pose& pose : bundled_poses("bolt-nut.turning.txt")) {
    Work work;
    intersects({bolt}, {nut, pose}, &work);
    EXPECT_GT(work.volume_tests, 40000u);
    EXPECT_EQ(work.exact_tests, 0u);
    Work by_boxes;
    intersects({bolt}, {nut, pose}, {.volume = PairVolume::Aabb}, &by_boxes);
    EXPECT_GT(by_boxes.triangle_tests, 40000u);
    EXPECT_EQ(by_boxes.exact_tests, 0u);
  }
}

// Tilting the nut further presses more of the thread together.
TEST(BundledPosesOfTheCrossedNut, BindMoreAndMore) {
  const Mesh bolt = bundled_mesh("bolt.obj");
  const Mesh nut = bundled_mesh("nut.stl");
  std::size_t last = 0;
  for (const Pose& pose : bundled_poses("bolt-nut.cross.txt")) {
    const std::size_t pairs = find_triangle_pairs({bolt}, {nut, pose}).size();
    EXPECT_GE(pairs, last);
    last = pairs;
  }
}

}  // namespace
}  // namespace graze
