// `graze explain`: what it says is so.

#include <graze/engine/cases/json_cursor.h>
#include <graze/engine/cli/explanation.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>
#include <gtest/gtest.h>
#include <algorithm>

#include "tests/shapes/formula_meshes.h"

namespace graze::cli {
namespace {

class CliExplain : public testing::Test {
 protected:
  Explanation at(double x) {
    pose_.translation() << x, 0.125, 0.0625;
    return explain({torus_}, {box_, pose_});
  }

  Mesh torus_ = tests::make_torus(1, 0.25, 20, 12);
  Mesh box_ = tests::make_box({0.5, 0.5, 0.5});
  Pose pose_ = Pose::Identity();
};

TEST_F(CliExplain, AHitHasAWitness) {
  const Explanation hit = at(1);
  EXPECT_TRUE(hit.intersects);
  const TrianglePairs pairs = find_triangle_pairs({torus_}, {box_, pose_});
  EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), hit.pair));
  EXPECT_EQ(hit.gap, 0);
  EXPECT_EQ(hit.point_a, hit.point_b);
  EXPECT_FALSE(hit.axis);
  EXPECT_LT(hit.widest.gap, 0);
  EXPECT_NE(to_text(hit).find("witness point"), std::string::npos);
}

TEST_F(CliExplain, AMissHasTheAxisOfThePairThatCameClosest) {
  const Explanation miss = at(2.5);
  EXPECT_FALSE(miss.intersects);
  const MeshDistance gap = distance({torus_}, {box_, pose_});
  EXPECT_EQ(miss.pair, gap.pair);
  EXPECT_EQ(miss.gap, gap.distance);
  const Triangle a = torus_.triangle(miss.pair.a);
  const Triangle b = place(pose_, box_.triangle(miss.pair.b));
  const auto along = [&](const Eigen::Vector3d& p) { return miss.axis->dot(p); };
  const double low_b = std::min({along(b.a), along(b.b), along(b.c)});
  const double high_a = std::max({along(a.a), along(a.b), along(a.c)});
  EXPECT_NEAR(low_b - high_a, gap.distance, 1e-14);
  EXPECT_EQ(miss.widest.name, "x of A");
  EXPECT_NEAR(miss.widest.gap, 2.5 - 1.25 - 0.5, 1e-12);
  EXPECT_NE(to_text(miss).find("bounding volumes alone"), std::string::npos);
}

TEST_F(CliExplain, JsonSaysTheSame) {
  const Explanation miss = at(2.5);
  const std::string name = "out";
  const cases::JsonValue tree = cases::parse_json(to_json(miss), name);
  const cases::JsonCursor root(tree, name);
  EXPECT_FALSE(root.member("intersects").boolean());
  EXPECT_EQ(root.member("gap").number(), miss.gap);
  EXPECT_EQ(root.member("axis").point(), *miss.axis);
  const cases::JsonCursor volumes = root.member("volumes");
  for (const Volume volume : kVolumes)
    EXPECT_GT(volumes.member(graze::name_of(volume)).member("volume_tests").number(), 0);
}

}  // namespace
}  // namespace graze::cli
