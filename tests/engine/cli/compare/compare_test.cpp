// `graze compare` and `graze replay` with engines that are wrong on purpose: what is found, what is
// written, what the exit codes say.

#include <graze/bvh/error.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/cli/compare/compare_report.h>
#include <graze/engine/cli/compare/html_report.h>
#include <graze/engine/cli/outlines/svg_picture.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/replay_run.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/compare/run/record/baseline.h>
#include <graze/engine/mesh/distance.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

TEST_F(CliCompare, AWrongPeerIsFoundShrunkAndReplayed) {
  options_.query = "pairs";
  options_.keep = 3;
  options_.report = directory_.path("report.html");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered) << "graze is right";
  EXPECT_NE(out_.find("absent: not found when this command was built"), out_.npos);
  ASSERT_EQ(found().size(), 3u) << out_;
  for (const std::filesystem::path& file : found()) {
    const Case small = read_case(file);
    EXPECT_EQ(small.answered_by.engine, "fcl");
    const compare::MeshCase meshes = *compare::as_meshes(small);
    EXPECT_EQ(meshes.a.mesh.triangles().size() + meshes.b.mesh.triangles().size(), 2u);
    const ExitCode code = run([&](Output& output) {
      return run_replay({.files = {file.string()}}, with_wrong_fcl(), output);
    });
    EXPECT_EQ(code, ExitCode::Answered);
    EXPECT_NE(out_.find("(recorded)"), out_.npos);
    EXPECT_NE(out_.find("wrong"), out_.npos);
    EXPECT_NE(out_.find("real"), out_.npos) << out_;
    EXPECT_NE(out_.find("1 case, graze wrong in 0"), out_.npos);
  }
  const std::string page = read("report.html");
  for (const std::filesystem::path& file : found())
    EXPECT_NE(page.find(file.filename().string()), page.npos);
}

TEST_F(CliCompare, AWrongGrazeIsExitCodeOne) {
  options_.query = "pairs";
  options_.random = 24;
  options_.keep = 2;
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", compare::make_inward_rounding_engine("graze", 0.02)});
  engines.push_back({"honest", compare::make_graze_engine()});
  EXPECT_EQ(compare(engines), ExitCode::GrazeWrong);
  ASSERT_EQ(found().size(), 2u);
  const ExitCode code = run([&](Output& output) {
    return run_replay({.files = {options_.cases}, .is_json = true}, engines, output);
  });
  EXPECT_EQ(code, ExitCode::GrazeWrong);
}

TEST_F(CliCompare, JsonIsALineForEachPoseAndASummary) {
  options_.is_json = true;
  options_.random = 24;
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  std::istringstream lines(out_);
  std::string line;
  std::size_t poses = 0;
  std::size_t wrong = 0;
  const std::string name = "out";
  while (std::getline(lines, line)) {
    const cases::JsonValue tree = cases::parse_json(line, name);
    const cases::JsonCursor root(tree, name);
    if (root.has("pose")) {
      EXPECT_EQ(root.member("pose").index(100), poses++);
      continue;
    }
    if (root.has("advice")) continue;
    EXPECT_EQ(root.member("summary").size(), 2u);
    const cases::JsonCursor summaries = root.member("summary");
    const cases::JsonCursor fcl = summaries.item(1);
    EXPECT_EQ(fcl.member("engine").text(), "fcl");
    wrong = fcl.member("wrong").index(1000);
    EXPECT_EQ(fcl.member("answers").index(1000), 24u);
  }
  EXPECT_EQ(poses, 24u);
  EXPECT_GT(wrong, 0u);
}

TEST_F(CliCompare, AStoppedRunGoesOn) {
  options_.resume = directory_.path("run.jsonl");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string whole = read("run.jsonl");
  const std::string first_result = out_;
  // As if it had been stopped in the middle of a line.
  directory_.write("run.jsonl", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string record = read("run.jsonl");
  EXPECT_EQ(std::count(record.begin(), record.end(), '\n'), 2)
      << "a line for the job, and one more";
  EXPECT_EQ(out_.substr(0, out_.find("  engine   answers")),
            first_result.substr(0, first_result.find("  engine   answers")));
  options_.seed = 2;
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "a record of other poses";
  directory_.write("run.jsonl",
                   "{\"graze_comparison\":1,\"key\":\"x\",\"poses\":1}\n{\"pose\":7}\n");
  EXPECT_THROW(compare(with_wrong_fcl()), CaseError);
}

TEST_F(CliCompare, BaselinesSeeAChangedBit) {
  options_.query = "distance";
  options_.random = 4;
  options_.time_tolerance = 1e9;
  options_.save = directory_.path("base");
  EXPECT_EQ(compare(graze_and(compare::make_wrong_sign_engine("fcl"))), ExitCode::Answered);
  options_.save.clear();
  options_.against = directory_.path("base");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_NE(out_.find(": 0 answers of graze changed"), out_.npos) << out_;
  EXPECT_EQ(compare(graze_changed_by(1e-9)), ExitCode::GrazeWrong);
  EXPECT_NE(out_.find(": 4 answers of graze changed in poses 0 1 2 3"), out_.npos) << out_;
  options_.seed = 5;
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
}

TEST_F(CliCompare, BaselinesHoldEveryEngineWithinATolerance) {
  options_.query = "distance";
  options_.random = 4;
  options_.time_tolerance = 1e9;
  options_.save = directory_.path("base");
  EXPECT_EQ(compare(graze_and(compare::make_off_engine("fcl", 0))), ExitCode::Answered);
  options_.save.clear();
  options_.against = directory_.path("base");
  EXPECT_EQ(compare(graze_and(compare::make_off_engine("fcl", 1e-6))), ExitCode::Answered);
  EXPECT_NE(out_.find("4 answers of fcl changed in poses 0 1 2 3 (4 from right to wrong"),
            out_.npos)
      << out_;
  options_.fail_on = {"fcl:changed"};
  EXPECT_EQ(compare(graze_and(compare::make_off_engine("fcl", 1e-6))), ExitCode::Failed);
  options_.answer_tolerance = 1e-5;
  EXPECT_EQ(compare(graze_and(compare::make_off_engine("fcl", 1e-6))), ExitCode::Answered);
  EXPECT_NE(out_.find("0 answers of fcl changed"), out_.npos) << out_;
  options_.against.clear();
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "nothing to have changed from";
}

TEST(Baseline, TimesAreJudgedByTheirMedian) {
  using compare::SaidThere;
  std::vector<SaidThere> old;
  for (const double time : {10000, 10, 12, 9})
    old.push_back({.engine = "graze", .digest = "x", .time = time});
  const auto held = [&](const std::vector<SaidThere>& now) {
    compare::Baseline baseline;
    for (std::size_t i = 0; i < old.size(); ++i)
      baseline.add(i, {&old[i], 1}, {&now[i], 1});
    return baseline.changes().front();
  };
  std::vector<SaidThere> now = old;
  EXPECT_EQ(held(now).time_ratio, 1);
  now[0].time = 30000;  // the first, which builds the trees, or one slow moment
  EXPECT_EQ(held(now).time_ratio, 1);
  now = old;
  for (std::size_t i = 1; i < now.size(); ++i)
    now[i].time *= 3;
  EXPECT_EQ(held(now).time_ratio, 3);
  now[1].digest = "y";
  EXPECT_EQ(held(now).places, (std::vector<std::size_t>{1}));
  now[1].digest.clear();
  EXPECT_EQ(held(now).missing, 1u);
}

TEST_F(CliCompare, ARecordIsOfOneQuestionAndOfItsEngines) {
  options_.query = "within";
  options_.clearance = 0.5;
  options_.random = 2;
  options_.resume = directory_.path("run.jsonl");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  options_.clearance = 0.25;
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "another clearance";
  options_.clearance = 0.5;
  options_.engines = "graze";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "an engine less";
}

TEST_F(CliCompare, ARecordThatNamesTrianglesThatAreNotThereIsHarmless) {
  options_.query = "pairs";
  options_.resume = directory_.path("run.jsonl");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  std::string text = read("run.jsonl");
  for (std::size_t at = 0; (at = text.find("\"culprit\":[", at)) != text.npos; ++at)
    text.insert(at + 11, "99999");
  directory_.write("run.jsonl", sealed_again(text));
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(found().size(), 1u);
}

TEST_F(CliCompare, BadInputIsRefusedBeforeAnything) {
  options_.pose_b = "1 0 0 0 0 1 0 0 0 0 1 0";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.pose_b.clear();
  options_.engines = "fcl,absent";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.engines = "nobody";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.engines.clear();
  options_.query = "within";
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.query = "any";
  options_.random = 0;
  options_.seed = 4;
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "of no random poses";
  options_.seed.reset();
  options_.random = 12;
  options_.time_tolerance = std::nan("");
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError);
  options_.time_tolerance = 1.5;
  options_.report = directory_.path("nowhere/report.html");
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "known only after the run";
  options_.report = directory_.path("");
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "a folder";
  options_.report.clear();
  EXPECT_TRUE(found().empty());
  options_.mesh_b.clear();
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "A alone is no folder";
}

/// A box that passes by another one and a ball, in eleven steps.
class CliCompareScenes : public CliCompare {
 protected:
  CliCompareScenes() {
    options_.mesh_a = directory_.write("scene.json", R"({
      "graze_scene": 1, "step": 0.2, "steps": 10,
      "shapes": [{"name": "m", "mesh": {"file": "b.off"}}, {"name": "s", "sphere": {"radius": 0.5}}],
      "bodies": [
        {"name": "rest", "shape": "m", "pose": {"position": [0.75, 0, 0]}, "motion": "static"},
        {"name": "ball", "shape": "s", "pose": {"position": [-1, 0.25, 0]}, "motion": "static"},
        {"name": "goes", "shape": "m", "pose": {"position": [-1, 0, 0]},
         "path": {"velocity": [1, 0.25, 0]}}]})");
    options_.mesh_b.clear();
    options_.random = 0;
  }

  /// What was said, without the times.
  std::string said() const { return out_.substr(0, out_.find("  engine   answers")); }
};

TEST_F(CliCompareScenes, AWrongPeerIsFoundShrunkAndReported) {
  options_.keep = 100;
  options_.report = directory_.path("report.html");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered) << "graze is right";
  const std::string page = read("report.html");
  std::size_t mesh_cases = 0;
  std::size_t body_cases = 0;
  for (const std::filesystem::path& file : found()) {
    const Case small = read_case(file);
    if (const std::optional<compare::MeshCase> meshes = compare::as_meshes(small)) {
      ++mesh_cases;
      // The boxes are in line, and a pair that merely touches is no plain error: four show one.
      EXPECT_LE(meshes->a.mesh.triangles().size() + meshes->b.mesh.triangles().size(), 4u);
    } else {
      ++body_cases;
      const std::optional<compare::BodyCase> bodies = compare::as_bodies(small);
      ASSERT_TRUE(bodies) << file;
      EXPECT_EQ(bodies->a.shape.kind(), ShapeKind::Sphere);
      EXPECT_LE(bodies->b.shape.as<Mesh>()->triangles().size(), 2u);
    }
    EXPECT_NE(page.find(file.filename().string()), page.npos);
    const ExitCode code = run([&](Output& output) {
      return run_replay({.files = {file.string()}}, with_wrong_fcl(), output);
    });
    EXPECT_EQ(code, ExitCode::Answered) << out_;
    EXPECT_NE(out_.find("wrong"), out_.npos) << out_;
  }
  EXPECT_GT(mesh_cases, 0u);
  EXPECT_GT(body_cases, 0u);
  EXPECT_EQ(page.find("no picture: its numbers"), page.npos);
  EXPECT_NE(page.find(": rest, goes</td><td>fcl"), page.npos) << page;
  EXPECT_NE(page.find("11 steps"), page.npos);
}

TEST_F(CliCompareScenes, AStoppedRunGoesOn) {
  options_.resume = directory_.path("run.jsonl");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string whole = read("run.jsonl");
  const std::string first_result = said();
  EXPECT_NE(first_result.find("11 steps, 22 questions"), first_result.npos) << first_result;
  directory_.write("run.jsonl", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(said(), first_result);
  options_.threads = 1;
  options_.resume.clear();
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(said(), first_result);
  options_.resume = directory_.path("run.jsonl");
  options_.steps = 4;
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "a record of more steps";
  options_.steps.reset();
  directory_.write("b.off", off_of(tests::make_box({0.5, 0.5, 0.75})));
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "a record of another mesh";
  directory_.write("b.off", off_of(tests::make_box({0.5, 0.5, 0.5})));
  const std::string header = whole.substr(0, whole.find('\n') + 1);
  for (const char* line : {"{\"step\":11}\n", "{\"step\":\"0x1p-1\"}\n", "[\n", "{\"pose\":1}\n"}) {
    directory_.write("run.jsonl", header + line);
    EXPECT_THROW(compare(with_wrong_fcl()), CaseError) << line;
    directory_.write("run.jsonl", sealed_again(header + line));
    EXPECT_THROW(compare(with_wrong_fcl()), CaseError) << line;
  }
}

TEST_F(CliCompareScenes, BaselinesSeeAChangedBit) {
  options_.time_tolerance = 1e9;
  options_.save = directory_.path("base");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  options_.save.clear();
  options_.against = directory_.path("base");
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_NE(out_.find(": 0 answers of graze changed, 0 missing"), out_.npos) << out_;
  const std::string whole = read("base");
  std::string text = whole;
  const std::size_t digest = text.find("\"digest\":\"", text.find("\"step\":3")) + 10;
  text[digest] = text[digest] == '0' ? '1' : '0';
  directory_.write("base", text);
  EXPECT_THROW(compare(with_wrong_fcl()), CaseError) << "a sum that is another";
  directory_.write("base", sealed_again(text));
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::GrazeWrong);
  EXPECT_NE(out_.find(": 1 answers of graze changed in steps 3, 0 missing"), out_.npos) << out_;
  directory_.write("base", whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::GrazeWrong);
  EXPECT_NE(out_.find(": 0 answers of graze changed, 1 missing"), out_.npos) << out_;
  options_.step = 0.25;
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "a record of other times";
}

TEST_F(CliCompare, GrazingPosesAreNextToTheTouch) {
  const Mesh a = tests::make_torus(1, 0.25, 10, 8);
  const Mesh b = tests::make_box({0.5, 0.5, 0.5});
  const std::vector<Pose> poses = compare::grazing_poses({a}, b, 6, 3);
  ASSERT_EQ(poses.size(), 6u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(intersects({a}, {b, poses[i]}), i % 2 == 0);
    EXPECT_LT(distance({a}, {b, poses[i]}).distance, 1e-12);
  }
  EXPECT_TRUE(compare::grazing_poses({a}, b, 1, 3)[0].isApprox(poses[0], 0)) << "reproducible";
}

TEST(CliReport, ThePageNeedsNothingElse) {
  compare::ShrunkCase shrunk{"<script>",
                             0,
                             Case{.note = "",
                                  .ask = Ask::Any,
                                  .settings = {},
                                  .a = Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                  .b = Triangle{{0, 0, 1}, {1, 0, 1}, {0, 1, 2}},
                                  .answer = std::nullopt,
                                  .answered_by = {}},
                             {}};
  const std::vector<WrittenCase> cases = {{shrunk, 7, "7", "it's/<b>\"x\".json"}};
  const auto answer =
      std::make_shared<const compare::AnswerRecord>(compare::AnswerRecord{.engine = "<em>",
                                                                          .digest = "",
                                                                          .brief = "yes",
                                                                          .time = 0,
                                                                          .is_agreed = false,
                                                                          .judgement = {}});
  const std::vector<compare::WrongAnswer> wrong = {
      {.place = 3, .where = "3: <u>, \"v\"", .name = "", .answer = answer}};
  const std::string page = html_report({.mesh_a = "a&b.off",
                                        .mesh_b = "http://x",
                                        .query = "any",
                                        .places = "1 poses",
                                        .place = "pose",
                                        .summaries = {},
                                        .wrong = wrong,
                                        .cases = cases,
                                        .viewer = {.note = "too <em>large</em>"}});
  EXPECT_EQ(page.find("<script"), page.rfind("<script")) << "its own alone";
  for (const char* reference :
       {"src=", "href", "url(", "@import", "<link", "<img", "<iframe", "<b>\"x", "<em>", "<u>"}) {
    EXPECT_EQ(page.find(reference), page.npos) << reference;
  }
  EXPECT_NE(page.find("&lt;script&gt;"), page.npos);
  EXPECT_NE(page.find("a&amp;b.off"), page.npos);
  EXPECT_NE(page.find("They cannot be turned here: too &lt;em&gt;large"), page.npos);
  EXPECT_NE(page.find("graze replay 'it'\\''s/&lt;b&gt;&quot;x&quot;.json'"), page.npos) << page;
  const std::string picture = svg_picture(shrunk.query);
  std::size_t polygons = 0;
  for (std::size_t at = 0; (at = picture.find("<polygon", at)) != picture.npos; ++at)
    ++polygons;
  EXPECT_EQ(polygons, 4u) << "two triangles from two sides";
  EXPECT_NE(page.find(picture), page.npos);
}

}  // namespace
}  // namespace graze::cli
