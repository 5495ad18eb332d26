// `graze compare` and `graze replay` about first contacts, with an engine that sees no motion.

#include <graze/bvh/error.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/output/outcome.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <string>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

/// The box comes from the side, passes the torus, and goes away.
class CliCompareMotions : public CliCompare {
 protected:
  CliCompareMotions() {
    options_.random = 0;
    options_.query = "first_contact";
    options_.poses = directory_.write("poses.txt",
                                      "1 0 0 4  0 1 0 0  0 0 1 0\n"
                                      "1 0 0 -4  0 1 0 0  0 0 1 0\n"
                                      "1 0 0 -4  0 0 -1 5  0 1 0 0\n"
                                      "1 0 0 4  0 0 -1 5  0 1 0 0\n");
  }

  static std::vector<EngineEntry> with_still_peer() {
    return graze_and(compare::make_motionless_engine("still"));
  }

  std::string refusal() {
    try {
      compare(with_still_peer());
    } catch (const UsageError& error) {
      return error.what();
    } catch (const PoseError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(CliCompareMotions, EachStretchOfAPathIsAMotion) {
  options_.report = directory_.path("report.html");
  EXPECT_EQ(compare(with_still_peer()), ExitCode::Answered) << out_;
  EXPECT_NE(out_.find("3 motions\n"), out_.npos) << out_;
  EXPECT_NE(out_.find(": missed"), out_.npos) << out_;
  ASSERT_EQ(found().size(), 1u) << out_;
  const Case small = read_case(found().front());
  EXPECT_EQ(small.ask, Ask::FirstContact);
  EXPECT_EQ(small.answered_by.engine, "still");
  EXPECT_EQ(std::get<CaseMesh>(*small.b).course->shift, Eigen::Vector3d(-8, 0, 0));
  EXPECT_EQ(std::get<CaseMesh>(small.a).mesh.triangles().size(), 1u);
  const ExitCode code = run([&](Output& output) {
    return run_replay({.files = {options_.cases}}, with_still_peer(), output);
  });
  EXPECT_EQ(code, ExitCode::Answered);
  EXPECT_NE(out_.find(" first_contact "), out_.npos) << out_;
  EXPECT_NE(out_.find("1 case, graze wrong in 0, changed in 0"), out_.npos) << out_;
}

TEST_F(CliCompareMotions, YesOrNoAndAClearance) {
  options_.query = "free";
  EXPECT_EQ(compare(with_still_peer()), ExitCode::Answered) << out_;
  EXPECT_NE(out_.find(": missed"), out_.npos) << out_;
  options_.clearance = 5;
  EXPECT_EQ(compare(with_still_peer()), ExitCode::Answered) << out_;
  EXPECT_NE(out_.find("3 motions\n"), out_.npos) << out_;
}

TEST_F(CliCompareMotions, ARecordKnowsItsMotions) {
  options_.save = directory_.path("base");
  options_.time_tolerance = 1e9;
  EXPECT_EQ(compare(with_still_peer()), ExitCode::Answered);
  options_.save.clear();
  options_.against = directory_.path("base");
  EXPECT_EQ(compare(with_still_peer()), ExitCode::Answered) << out_;
  options_.poses = directory_.write("others.txt",
                                    "1 0 0 4  0 1 0 0  0 0 1 0\n"
                                    "1 0 0 -4  0 1 0 0  0 0 1 0\n"
                                    "1 0 0 -4  0 0 -1 5  0 1 0 0\n"
                                    "1 0 0 4  0 0 -1 6  0 1 0 0\n");
  EXPECT_NE(refusal().find("poses of B"), std::string::npos) << "the last pose is another";
}

TEST_F(CliCompareMotions, WhatIsRefused) {
  const std::string poses = *options_.poses;
  options_.poses.reset();
  EXPECT_EQ(refusal(),
            "--query first_contact needs --poses: B moves from each of them to the next");
  options_.poses = directory_.write("one.txt", "1 0 0 4  0 1 0 0  0 0 1 0\n");
  EXPECT_NE(refusal().find("one.txt: one pose, a motion has two"), std::string::npos);
  options_.poses = poses;
  options_.query = "any";
  options_.clearance = 1;
  EXPECT_EQ(refusal(), "--clearance belongs to --query within, first_contact and free");
}

TEST_F(CliCompareMotions, AFolderOfCasesIsJudgedWithWhatItRecords) {
  const std::filesystem::path folder = directory_.path() / "cases";
  std::filesystem::create_directory(folder);
  const Mesh cube = tests::make_box({1, 1, 1});
  const RigidMotion rests{Pose::Identity()};
  const RigidMotion comes(Pose(Eigen::Translation3d(3, 0, 0)), {.shift = {-2, 0, 0}});
  Case query = to_case(case_mesh(cube, rests), case_mesh(cube, comes),
                       first_contact({cube, rests}, {cube, comes}));
  write_case(folder / "met.json", query);
  query.answer->low = query.answer->high = 0.75;
  query.answered_by = {"somebody", "1"};
  write_case(folder / "late.json", query);
  options_.mesh_a = folder.string();
  options_.mesh_b.clear();
  options_.query = "any";
  options_.poses.reset();
  EXPECT_EQ(compare(with_still_peer()), ExitCode::Answered) << out_;
  EXPECT_NE(out_.find(": late by 0.25"), out_.npos) << out_;
  EXPECT_NE(out_.find("hit at 0.75"), out_.npos) << out_;
  EXPECT_NE(out_.find(": missed"), out_.npos) << out_;
  EXPECT_NE(out_.find("2 cases"), out_.npos) << out_;
}

}  // namespace
}  // namespace graze::cli
