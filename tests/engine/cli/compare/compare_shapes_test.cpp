// `graze compare` of shapes: poses by seed, the questions that shapes have, and engines that are
// wrong about them.

#include <graze/bvh/error.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

using nlohmann::json;

std::vector<std::pair<Shape, Shape>> pairs_of_shapes() {
  const std::vector<Eigen::Vector3d> corners = {{3, 0, 0}, {2, 0.5, 0}, {2, 0, 0.5}, {2, 0, 0}};
  return {{Sphere{{5, 0, 0}, 1}, Box{{0.5, 0.25, 1}}},
          {Cone{0.5, 1}, Capsule{0.25, 0.5}},
          {ConvexHull(corners), Ellipsoid{{0, 2, 0}, {0.5, 0.25, 1}}},
          {HalfSpace{{0, 0.6, 0.8}, 3}, Cylinder{0.5, 0.25}},
          {Box{{1, 1, 1}}, HalfSpace{{1, 0, 0}, -2}},
          {Plane{{0, 0, 1}, 1}, Sphere{{0, 0, 0}, 0.5}},
          {tests::make_torus(1, 0.25, 10, 8), Capsule{0.25, 0.5}}};
}

Pose turned() {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d(0.6, 0, 0.8)).toRotationMatrix();
  pose.translation() << 1, -2, 0.5;
  return pose;
}

/// Hits and misses are both common, and the same seed gives the same poses.
TEST(ShapePoses, AtRandomMeetAndMiss) {
  for (const auto& [a, b] : pairs_of_shapes()) {
    SCOPED_TRACE(std::string(name_of(a.kind())) + "/" + name_of(b.kind()));
    const auto poses = compare::random_pose_source(CaseBody(a, turned()), b, 200, 3);
    const auto again = compare::random_pose_source(CaseBody(a, turned()), b, 200, 3);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < 200; ++i) {
      hits += intersects(PlacedShapeView{a, turned()}, {b, poses->at(i)});
      ASSERT_EQ(poses->at(i).matrix(), again->at(i).matrix());
    }
    EXPECT_GT(hits, 20u);
    EXPECT_LT(hits, 195u);
  }
}

/// Hits and misses in turn, and no further apart than one step of a double can be.
TEST(ShapePoses, GrazingOnesTouchAndMissInTurn) {
  for (const auto& [a, b] : pairs_of_shapes()) {
    SCOPED_TRACE(std::string(name_of(a.kind())) + "/" + name_of(b.kind()));
    const auto poses = compare::grazing_pose_source(CaseBody(a, turned()), b, 12, 3);
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_EQ(intersects(PlacedShapeView{a, turned()}, {b, poses->at(i)}), i % 2 == 0) << i;
      EXPECT_LT(distance(PlacedShapeView{a, turned()}, {b, poses->at(i)}).distance, 1e-8) << i;
    }
  }
  const Sphere ball{{0, 0, 0}, 1};
  const CaseBody space(HalfSpace{{0, 0, 1}, 0}, Pose::Identity());
  EXPECT_NO_THROW(compare::grazing_pose_source(space, ball, 4, 1)->at(3));
}

class CliCompareShapes : public CliCompare {
 protected:
  CliCompareShapes() {
    options_.mesh_a =
        directory_.write("a.json", R"({"capsule": {"radius": 0.25, "half_length": 0.5}})");
    options_.mesh_b =
        directory_.write("b.json", R"({"box": {"half_extents": [0.5, 0.25, 0.125]}})");
    options_.is_json = true;
    options_.keep = 0;
    options_.random = 60;
  }

  /// The summary of each engine that answered.
  json summary(const std::string& query, const std::vector<EngineEntry>& engines) {
    options_.query = query;
    EXPECT_EQ(compare(engines), ExitCode::Answered) << out_;
    const std::size_t at = out_.rfind("{\"summary\"");
    return json::parse(out_.substr(at, out_.find('\n', at) - at))["summary"];
  }
};

/// Whoever is installed is asked, and graze is never wrong.
TEST_F(CliCompareShapes, EveryQuestionIsAskedOfEveryEngine) {
  const std::vector<EngineEntry> engines = compare::all_engines();
  for (const bool is_grazing : {false, true}) {
    options_.random = is_grazing ? 0 : 60;
    options_.grazing = is_grazing ? 30 : 0;
    for (const std::string query : {"any", "distance", "contacts", "within", "separation"}) {
      SCOPED_TRACE(query + (is_grazing ? ", grazing" : ""));
      options_.clearance = query == "within" ? 0.125 : -1;
      for (const json& engine : summary(query, engines)) {
        const std::string name = engine["engine"];
        if (name == "graze") {
          EXPECT_EQ(engine["answers"], is_grazing ? 30 : 60);
          EXPECT_EQ(engine["wrong"], 0);
        }
        if (name == "fcl" || name == "bullet") {
          EXPECT_EQ(engine["answers"], is_grazing ? 30 : 60) << name;
        }
        EXPECT_EQ(engine["engine_error"], 0) << name << out_;
      }
    }
  }
}

/// Of meshes, too: a number that is no length of its translation is wrong in every pose.
TEST_F(CliCompareShapes, SeparationsOfMeshesAreAlwaysJudged) {
  options_.mesh_a = directory_.write("a.off", off_of(tests::make_torus(1, 0.25, 10, 8)));
  options_.mesh_b = directory_.write("b.off", off_of(tests::make_box({0.5, 0.5, 0.5})));
  options_.random = 24;
  const json engines = summary("separation", graze_and(compare::make_off_engine("mine", 0.125)));
  EXPECT_EQ(engines[0]["answers"], 24);
  EXPECT_EQ(engines[0]["wrong"], 0);
  EXPECT_GT(engines[0]["right"], 12);
  EXPECT_EQ(engines[1]["wrong"], 24);
}

TEST_F(CliCompareShapes, PartsOfThemAreOneRun) {
  const json whole = summary("any", with_wrong_fcl());
  for (int part = 1; part <= 3; ++part) {
    options_.part = std::to_string(part) + "/3";
    options_.resume = directory_.path("part" + std::to_string(part));
    const json some = summary("any", with_wrong_fcl());
    EXPECT_EQ(some[0]["answers"], 20) << whole;
  }
  options_.part.clear();
  options_.seed = 2;
  options_.resume = directory_.path("part1");
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "of other poses";
}

TEST_F(CliCompareShapes, WhatShapesDoNotHaveIsRefused) {
  options_.query = "pairs";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.query = "within";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "without a clearance";
}

}  // namespace
}  // namespace graze::cli
