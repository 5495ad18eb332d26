// `graze compare FOLDER`: records, baselines and reports of cases, and what is wrong in them.

#include <graze/bvh/error.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/compare/html_report.h>
#include <graze/engine/cli/outlines/svg_picture.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/replay_run.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

/// Five cases: meshes that fcl gets wrong and right, a ball in a box, a distance, and two
/// triangles.
class CliCompareFolder : public CliCompare {
 protected:
  CliCompareFolder() {
    std::filesystem::create_directory(folder_);
    Pose aside = Pose::Identity();
    aside.translation() << 1.25, 0.125, 0.0625;
    Pose behind = Pose::Identity();
    behind.translation() << 0, 3, 0.125;
    put("a-aside", to_case({torus_}, {box_, aside}, find_triangle_pairs({torus_}, {box_, aside})));
    put("b-behind", to_case({torus_}, {box_, behind}, intersects({torus_}, {box_, behind})));
    const CaseBody ball(Sphere{{0, 0, 0}, 0.5}, aside);
    const CaseBody cone(Cone{1, 1}, behind);
    put("c-ball", to_case(CaseShape(ball), cone,
                          intersects({ball.shape, ball.pose}, {cone.shape, cone.pose})));
    put("d-gap", to_case({torus_}, {box_, behind}, distance({torus_}, {box_, behind})));
    put("e-triangles", to_case(CaseShape(Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}),
                               Triangle{{1, 1, 0}, {1, 1, 5}, {2, 2, 5}}, true));
    options_.mesh_a = folder_.string();
    options_.mesh_b.clear();
    options_.random = 0;
    options_.keep = 8;
    options_.time_tolerance = 1e9;
  }

  void put(const std::string& name, Case query) const {
    query.note = name;
    write_case(folder_ / (name + ".json"), query);
  }

  /// What was said, without the times.
  std::string said() const { return out_.substr(0, out_.find("  engine   answers")); }

  const Mesh torus_ = tests::make_torus(1, 0.25, 10, 8);
  const Mesh box_ = tests::make_box({0.5, 0.5, 0.5});
  const std::filesystem::path folder_ = directory_.path() / "cases";
};

TEST_F(CliCompareFolder, AWrongPeerIsFoundShrunkAndReported) {
  options_.report = directory_.path("report.html");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered) << out_;
  EXPECT_NE(out_.find("absent: not found when this command was built"), out_.npos);
  EXPECT_NE(out_.find("5 cases"), out_.npos) << out_;
  EXPECT_NE(out_.find("a-aside.json       fcl"), out_.npos) << out_;
  EXPECT_NE(out_.find("real"), out_.npos) << out_;
  const std::vector<std::filesystem::path> cases = found();
  const auto file = std::find_if(cases.begin(), cases.end(), [](const auto& each) {
    return each.filename().string().starts_with("a_aside-fcl-pairs-real-");
  });
  ASSERT_NE(file, cases.end());
  const Case small = read_case(*file);
  const compare::MeshCase meshes = *compare::as_meshes(small);
  EXPECT_EQ(meshes.a.mesh.triangles().size() + meshes.b.mesh.triangles().size(), 2u);
  EXPECT_EQ(small.answered_by.engine, "fcl");
  EXPECT_NE(small.note.find("case a-aside.json: fcl says "), small.note.npos) << small.note;
  const std::string page = read("report.html");
  EXPECT_NE(page.find(file->filename().string() + "</code>"), page.npos) << page;
  EXPECT_NE(page.find("<td>a-aside.json</td><td>fcl</td>"), page.npos);
  EXPECT_NE(page.find("5 cases"), page.npos);
  EXPECT_EQ(page.find("no picture: its numbers"), page.npos);
  EXPECT_EQ(page.find("question <b>"), page.npos) << "each case has its own";
}

/// What is as small as it can be is not copied.
TEST_F(CliCompareFolder, AShrunkCaseStaysWhereItIs) {
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  bool is_kept = false;
  for (int i = 0; i < 4 && !is_kept; ++i) {  // digits that others needed may go in a second round
    options_.mesh_a = options_.cases;
    options_.cases = directory_.path("again" + std::to_string(i));
    EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
    is_kept = out_.find("shrunk: graze replay " + options_.mesh_a) != out_.npos;
  }
  EXPECT_TRUE(is_kept) << out_;
  EXPECT_TRUE(found().empty());
  EXPECT_NE(out_.find("recorded"), out_.npos) << out_;
}

TEST_F(CliCompareFolder, AWrongGrazeIsExitCodeOne) {
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", compare::make_inward_rounding_engine("graze", 0.7)});
  EXPECT_EQ(compare(engines), ExitCode::GrazeWrong) << out_;
}

/// Whether an open mesh is solid is no question; of many cases the line says which asks it.
TEST_F(CliCompareFolder, ARefusedQuestionIsNamed) {
  Case query = read_case(folder_ / "b-behind.json");
  const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const std::vector<TriangleIndices> sheet = {{0, 1, 2}};
  query.a = CaseMesh{Mesh(corners, sheet), Pose::Identity()};
  query.settings.hit = Hit::Solid;
  put("f-open", query);
  try {
    compare(with_wrong_fcl());
    ADD_FAILURE() << out_;
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find("f-open.json: mesh A is not closed"), 0u) << what;
  }
}

TEST_F(CliCompareFolder, AnAnswerOfGrazeThatHasChangedIsExitCodeOne) {
  Case query = read_case(folder_ / "d-gap.json");
  query.answer->distance = std::nextafter(*query.answer->distance, 0.0);
  put("d-gap", query);
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::GrazeWrong);
  EXPECT_NE(out_.find("recorded: "), out_.npos) << out_;
}

TEST_F(CliCompareFolder, WhatARecordLeavesOutIsNotCompared) {
  Case query = read_case(folder_ / "d-gap.json");
  query.answer->point_a.reset();
  query.answer->point_b.reset();
  query.answer->pair.reset();
  put("d-gap", query);
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(out_.find("recorded: "), out_.npos) << out_;
}

/// A gap of an ulp is a touch of two boxes by law 11, and none in real numbers.
TEST_F(CliCompareFolder, ALawIsNoChangeOfWhatTheRefereeRecorded) {
  Case query;
  query.ask = Ask::Any;
  const Pose turned(Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()));
  Pose beside = turned;
  beside.translation() = turned.linear() * Eigen::Vector3d(2 + 0x1p-51, 0, 0);
  query.a = CaseBody(Box{{1, 1, 1}}, turned);
  query.b = CaseBody(Box{{1, 1, 1}}, beside);
  query.answer.emplace().says = false;
  query.answered_by = {"referee", ""};
  put("f-kissing", query);
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered) << out_;
}

TEST_F(CliCompareFolder, AStoppedRunGoesOn) {
  options_.resume = directory_.path("run.jsonl");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string whole = read("run.jsonl");
  const std::string first_result = said();
  directory_.write("run.jsonl", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(said(), first_result);
  const std::string again = read("run.jsonl");
  EXPECT_EQ(std::count(again.begin(), again.end(), '\n'), 6);
  options_.resume.clear();
  options_.threads = 1;
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(said(), first_result);
  options_.resume = directory_.path("run.jsonl");
  options_.engines = "graze";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "an engine less";
  options_.engines.clear();
  std::filesystem::remove(folder_ / "e-triangles.json");
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "a case less";
  put("e-triangles", read_case(folder_ / "d-gap.json"));
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "another case";
}

TEST_F(CliCompareFolder, BaselinesSeeAChangedBit) {
  options_.save = directory_.path("base");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  options_.save.clear();
  options_.against = directory_.path("base");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_NE(out_.find(": 0 answers of graze changed, 0 missing"), out_.npos) << out_;
  const std::string whole = read("base");
  std::string text = whole;
  const std::size_t graze = text.find("\"engine\":\"graze\"", text.find("\"case\":2,"));
  const std::size_t digest = text.find("\"digest\":\"", graze) + 10;
  text[digest] = text[digest] == '0' ? '1' : '0';
  directory_.write("base", sealed_again(text));
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::GrazeWrong);
  EXPECT_NE(out_.find(": 1 answers of graze changed in cases c-ball.json, 0 missing"), out_.npos)
      << out_;
  directory_.write("base", whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::GrazeWrong);
  EXPECT_NE(out_.find(": 0 answers of graze changed, 1 missing"), out_.npos) << out_;
  const std::string header = whole.substr(0, whole.find('\n') + 1);
  for (const char* line : {"{\"case\":5,\"answers\":[]}\n", "{\"pose\":1}\n", "[\n"}) {
    directory_.write("base", sealed_again(header + line));
    try {
      compare(with_wrong_fcl());
      FAIL() << line;
    } catch (const CaseError& error) {
      EXPECT_NE(std::string(error.what()).find("base:2:"), std::string::npos) << error.what();
    }
  }
  directory_.write("base", sealed_again("{\"graze_comparison\":2,\"key\":\"\",\"asked\":[],"
                                        "\"engines\":[],\"poses\":1}\n"));
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "a record of poses";
}

TEST_F(CliCompareFolder, JsonIsALineForEachCaseAndASummary) {
  options_.is_json = true;
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  std::istringstream lines(out_);
  std::string line;
  std::size_t cases = 0;
  const std::string name = "out";
  while (std::getline(lines, line)) {
    const cases::JsonValue tree = cases::parse_json(line, name);
    const cases::JsonCursor root(tree, name);
    if (root.has("advice")) continue;
    if (!root.has("case")) {
      EXPECT_EQ(root.member("summary").size(), 3u) << "recorded, graze, fcl";
      EXPECT_GT(root.member("cases").size(), 0u);
      continue;
    }
    EXPECT_EQ(root.member("case").index(100), cases);
    if (cases == 3) {
      EXPECT_EQ(root.member("file").text(), "d-gap.json");
      EXPECT_EQ(root.member("question").text(), "distance");
    }
    ++cases;
  }
  EXPECT_EQ(cases, 5u);
}

TEST_F(CliCompareFolder, TheEnginesAreChosen) {
  options_.engines = "graze";
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(out_.find("fcl"), out_.npos) << out_;
  EXPECT_NE(out_.find("no wrong answer"), out_.npos) << out_;
}

TEST_F(CliCompareFolder, BadInputIsRefusedBeforeAnything) {
  options_.random = 3;
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.random = 0;
  options_.query = "pairs";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.query = "any";
  options_.report = directory_.path("nowhere/report.html");
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.report.clear();
  std::ofstream(folder_ / "f.json") << "{";
  EXPECT_THROW(compare(with_wrong_fcl()), CaseError);
  EXPECT_TRUE(out_.empty());
  EXPECT_TRUE(found().empty());
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directory(folder_);
  EXPECT_THROW(compare(with_wrong_fcl()), CaseError) << "no case";
}

/// The same cases in one file, one on each line.
TEST_F(CliCompareFolder, ManyCasesInOneFileAreTheSameCases) {
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  std::string text;
  for (const std::filesystem::path& file : case_files({folder_.string()})) {
    std::string one = to_json(read_case(file));
    std::replace(one.begin(), one.end(), '\n', ' ');
    text += one + "\n";
  }
  ASSERT_EQ(std::count(text.begin(), text.end(), '\n'), 5) << text;
  options_.mesh_a = directory_.write("many.jsonl", text);
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered) << out_;
  EXPECT_NE(out_.find("5 cases"), out_.npos) << out_;
  EXPECT_NE(out_.find("many.jsonl:1       fcl"), out_.npos) << out_;
  const auto replayed = [&] {
    return run([&](Output& output) {
      return run_replay({.files = {options_.mesh_a}}, with_wrong_fcl(), output);
    });
  };
  EXPECT_EQ(replayed(), ExitCode::Answered);
  EXPECT_NE(out_.find("5 cases, graze wrong in 0"), out_.npos) << out_;
  directory_.write("many.jsonl", text + "{}\n");
  EXPECT_EQ(replayed(), ExitCode::BadInput) << "the others are replayed";
  EXPECT_NE(out_.find("5 cases"), out_.npos) << out_;
  try {
    compare(with_wrong_fcl());
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(std::string(error.what()).find(options_.mesh_a + ":6:1: "), 0u) << error.what();
  }
}

TEST(CliPictures, EveryShapeIsDrawnFromTwoSides) {
  Pose pose = Pose::Identity();
  pose.translation() << 1, 2, 3;
  const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Shape> shapes = {Sphere{{0, 0, 0}, 1},
                                     Box{{1, 2, 3}},
                                     Capsule{1, 1},
                                     Cylinder{1, 1},
                                     Cone{1, 1},
                                     Ellipsoid{{0, 0, 0}, {1, 2, 3}},
                                     ConvexHull(corners),
                                     HalfSpace{{0, 0, 1}, 0},
                                     Mesh(corners, std::vector<TriangleIndices>{{0, 1, 2}})};
  const auto polygons = [](const std::string& picture) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = picture.find("<polygon", at)) != picture.npos; ++at)
      ++count;
    return count;
  };
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      const std::string picture =
          svg_picture(to_case(CaseShape(CaseBody(a, Pose::Identity())), CaseBody(b, pose), true));
      EXPECT_EQ(polygons(picture), 4u) << name_of(a.kind()) << "/" << name_of(b.kind());
      EXPECT_EQ(picture.find("nan"), picture.npos);
    }
  }
  const CaseShape triangle = Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(polygons(svg_picture(to_case(triangle, Aabb{{0, 0, 0}, {1, 1, 1}}, true))), 4u);
  EXPECT_EQ(polygons(svg_picture(to_case(triangle, Obb{pose, {1, 1, 1}}, true))), 4u);
  EXPECT_EQ(polygons(svg_picture(to_case(triangle, Sphere{{0, 0, 0}, 1}, true))), 4u);
  const std::string huge = svg_picture(
      to_case(triangle, Triangle{{-1.7e308, 0, 0}, {1.7e308, 0, 0}, {0, 1.7e308, 0}}, true));
  EXPECT_EQ(huge, "") << "beyond what can be drawn";
}

}  // namespace
}  // namespace graze::cli
