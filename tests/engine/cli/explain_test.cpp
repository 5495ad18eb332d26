// `graze explain`: what it says is so.

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/cli/reports/explanation.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <vector>

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
  EXPECT_EQ(miss.decider, Decider::MeshBoxes);
  EXPECT_NE(to_text(miss).find("the boxes around the meshes alone"), std::string::npos);
  ASSERT_TRUE(miss.boxes);
  EXPECT_EQ(miss.boxes->triangles_a, torus_.triangles().size());
}

TEST_F(CliExplain, TheBoxesThatAreApartHoldThePair) {
  int below_the_roots = 0;
  const Mesh grain = tests::make_box({0.02, 0.02, 0.02});
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.3, 0.2, 0),
                                     Eigen::Vector3d(0.2, -0.4, 0.1), Eigen::Vector3d(3, 0, 0)}) {
    pose_.translation() = way;
    const Explanation miss = explain({torus_}, {grain, pose_});
    ASSERT_TRUE(miss.boxes);
    const BoxAxis& axis = miss.boxes->axis;
    const Triangle a = torus_.triangle(miss.pair.a);
    const Triangle b = place(pose_, grain.triangle(miss.pair.b));
    const auto along = [&](const Eigen::Vector3d& p) { return axis.direction.dot(p); };
    const auto [low_a, high_a] = std::minmax({along(a.a), along(a.b), along(a.c)});
    const auto [low_b, high_b] = std::minmax({along(b.a), along(b.b), along(b.c)});
    EXPECT_GE(std::max(low_a - high_b, low_b - high_a), axis.gap - 1e-6);
    EXPECT_GT(axis.gap, 0);
    below_the_roots += miss.boxes->triangles_a < torus_.triangles().size();
  }
  EXPECT_GE(below_the_roots, 2);
}

TEST_F(CliExplain, WhatIsInsideHasNoBoxesThatAreApart) {
  const Mesh grain = tests::make_box({0.02, 0.02, 0.02});
  pose_.translation() << 1, 0.01, 0;  // in the tube of the torus
  const Explanation inside = explain({torus_}, {grain, pose_});
  EXPECT_FALSE(inside.intersects);
  EXPECT_NE(inside.decider, Decider::MeshBoxes);
  ASSERT_TRUE(inside.solids);
  EXPECT_EQ(*inside.solids, Solids::Meet);
  EXPECT_NE(to_text(inside).find("a part of one lies inside the other"), std::string::npos);
  pose_.translation() << 0, 0, 0;  // in its hole
  EXPECT_EQ(explain({torus_}, {grain, pose_}).solids, Solids::Apart);
}

// An edge an ulp over a plane: what decides is not a volume, and the words must not say so.
TEST_F(CliExplain, AMissThatOnlyExactArithmeticSeesSaysSo) {
  const auto mesh_of = [](std::vector<Eigen::Vector3d> corners) {
    return Mesh(corners, std::vector<TriangleIndices>{{0, 1, 2}});
  };
  const Mesh floor = mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 1}});
  const double up = std::nextafter(0.25, 1);
  const Mesh edge = mesh_of({{1, 1, up}, {2, 1, 0.25 + 1e-9}, {1, 1, 2}});
  const Explanation miss = explain({floor}, {edge});
  EXPECT_FALSE(miss.intersects);
  const Work& work = miss.volumes.front().work;
  EXPECT_EQ(miss.decider == Decider::Exact, work.exact_tests > 0);
  EXPECT_EQ(miss.decider, Decider::Exact);
  EXPECT_NE(to_text(miss).find("1 of them exact"), std::string::npos);
  EXPECT_FALSE(miss.solids);  // they are open
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
  for (const PairVolume volume : kPairVolumes)
    EXPECT_GT(volumes.member(graze::name_of(volume)).member("volume_tests").number(), 0);
}

}  // namespace
}  // namespace graze::cli
