// The programs of README.md and of samples/tour.md, word for word as they stand there, between what
// they take for granted and what must have come of them.

#include <graze/graze.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/files/temporary_directory.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace {

/// In a folder with the files that the page names; back where it was at the end.
class ReadmePrograms : public testing::Test {
 protected:
  ReadmePrograms() {
    const std::filesystem::path data = GRAZE_DATA_DIR;
    std::filesystem::copy(data / "meshes/bolt.obj", folder_.path());
    std::filesystem::copy(data / "meshes/nut.stl", folder_.path());
    std::filesystem::copy(data / "poses/bolt-nut.cross.txt", folder_.path("poses.txt"));
    std::filesystem::current_path(folder_.path());
  }
  ~ReadmePrograms() override { std::filesystem::current_path(before_); }

 private:
  graze::tests::TemporaryDirectory folder_;
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(ReadmePrograms, OfTheTour) {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0.2, 0.2, -1), e(0.2, 0.2, 1),
      f(3, 3, 3), p(0, 0, 0.005);
  std::vector<Eigen::Vector3d> new_vertices;
  const graze::Mesh straight = graze::load_mesh("bolt.obj");
  for (const Eigen::Vector3d& v : straight.vertices())
    new_vertices.push_back(v + Eigen::Vector3d(0.1 * v.z() * v.z(), 0, 0));

#include "tour_1.inc"

  EXPECT_TRUE(hit);
  EXPECT_EQ(same, hit);
  EXPECT_EQ(still, hit);
  EXPECT_TRUE(bent_hits);
  EXPECT_EQ(first.has_value() && first->is_at_start, graze::intersects({bolt}, {nut}));
  EXPECT_TRUE(drop.has_value() && drop->is_at_start);  // as both poses say
  EXPECT_FALSE(is_clear);
  EXPECT_EQ(met.status, graze::RigidStatus::Hit);
  EXPECT_EQ(met.high, 0);
  EXPECT_FALSE(proof.has_value());
  EXPECT_FALSE(pairs.empty());
  EXPECT_FALSE(curves.empty());
  EXPECT_EQ(foot.distance, std::abs(graze::signed_distance({bolt, pose}, p)));
  EXPECT_EQ(depths.size(), nut.vertices().size());
  EXPECT_TRUE(clash);
  EXPECT_TRUE(health.is_healthy());
  EXPECT_FALSE(contacts.empty());
  EXPECT_GT(apart.distance, 0);
  EXPECT_EQ(gap.distance, 0);
  EXPECT_EQ(now.distance, gap.distance);
  EXPECT_TRUE(close);
  ASSERT_EQ(poses.size(), 25u);
  ASSERT_EQ(hits.size(), poses.size());
  EXPECT_FALSE(hits.front());
  EXPECT_TRUE(hits.back());
  EXPECT_TRUE(in_box);
  EXPECT_FALSE(there.empty());
  EXPECT_FALSE(seen.has_value());  // through the hole of the nut
  EXPECT_FALSE(is_tangled);
  EXPECT_TRUE(tangles.empty());
  EXPECT_GT(work.volume_tests, 0u);
  EXPECT_TRUE(exact);
  EXPECT_TRUE(boxed);
  EXPECT_TRUE(near);
  EXPECT_TRUE(graze::contains(graze::Aabb{{-0.02, -0.02, -0.02}, {0.03, 0.03, 0.03}}, ball.centre));
  EXPECT_GT(ball.radius, 0.01);
  EXPECT_TRUE(inside);
  EXPECT_GT(voxels.size(), 1000u);
  EXPECT_EQ(kept_hits, hit);
  EXPECT_GT(beside.distance, 0);
  EXPECT_EQ(rows.rows(), static_cast<Eigen::Index>(bolt.vertices().size()));
}

TEST_F(ReadmePrograms, OfTwoMeshes) {
  int warnings = 0;
  const auto warn = [&](const graze::Pose&) { ++warnings; };

#include "readme_1.inc"
#include "readme_2.inc"

  EXPECT_TRUE(hit);
  EXPECT_FALSE(pairs.empty());
  EXPECT_FALSE(contacts.empty());
  EXPECT_EQ(gap.distance, 0);
  ASSERT_EQ(hits.size(), 25u);
  EXPECT_FALSE(hits.front());
  EXPECT_TRUE(hits.back());
  EXPECT_GT(warnings, 0);
  EXPECT_EQ(met.status, graze::RigidStatus::Hit);
  EXPECT_FALSE(is_clear);
}

/// True so many times.
struct Running {
  int steps;
  operator bool() { return steps-- > 0; }
};

TEST_F(ReadmePrograms, OfManyBodies) {
  using graze::tests::at;
  const graze::Pose floor_pose = at(0, 0, -0.1), start_pose = at(0, 0, 0.02),
                    next_pose = at(0, 0, 0.001);
  const graze::Mesh bolt = graze::load_mesh("bolt.obj");
  const graze::Aabb box{{0, 0, 0}, {1, 1, 1}};
  const Eigen::Vector3d eye(0, 0, 1), forward(0, 0, -1);
  Running running{3};
  int resolved = 0, forgotten = 0, stopped = 0, considered = 0;
  double aimed = 0;
  const auto resolve = [&](const graze::BodyContact&) { ++resolved; };
  const auto forget = [&](graze::BodyPair) { ++forgotten; };
  const auto stop = [&](const graze::BodyFirstContact&) { ++stopped; };
  const auto consider = [&](graze::BoxPair) { ++considered; };
  const auto aim = [&](graze::BodyId, double distance, const Eigen::Vector3d&) {
    aimed = distance;
  };

#include "readme_3.inc"

  EXPECT_TRUE(world.contains(floor));
  EXPECT_GT(resolved, 0);
  EXPECT_EQ(forgotten, 0);
  EXPECT_GT(stopped, 0);
  EXPECT_NEAR(aimed, 0.979, 1e-9);  // the tip of the bolt, 20 mm above its origin
  EXPECT_TRUE(boxes.contains(crate));
  EXPECT_EQ(considered, 0);
}

}  // namespace
