// A wrapper with planted errors before `graze compare`, over the pipe: one missed hit among many
// answers, a crash, a hang, a picometre in a distance, a normal that is turned round. Each is
// counted exactly, by one run and by eight parts of which one is killed and gone on with.

#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

using nlohmann::json;

/// What is planted in a pose of --random.
struct Planted {
  std::size_t pose;
  std::string fault;
};

class PlantedEngine : public CommandTest {
 protected:
  static constexpr std::size_t kParts = 8;

  void place(const Mesh& a, const Mesh& b) {
    write_mesh("a.off", a);
    write_mesh("b.off", b);
    a_ = load_mesh(folder_ / "a.off");
    b_ = load_mesh(folder_ / "b.off");
  }

  std::shared_ptr<const compare::PoseSource> poses(std::size_t count) const {
    return compare::random_pose_source(CaseMesh(*a_, Pose::Identity()), *b_, count, 1);
  }

  /// The first pose from `from` on that is so.
  static std::size_t pose_where(const compare::PoseSource& poses, std::size_t from,
                                const std::function<bool(const Pose&)>& is_so) {
    while (!is_so(poses.at(from)))
      ++from;
    return from;
  }

  /// The engine that has these errors.
  std::string engine(const compare::PoseSource& poses, const std::vector<Planted>& planted,
                     int sleep_us) const {
    json plan = {{"sleep_us", sleep_us}, {"planted", json::array()}};
    for (const Planted& each : planted) {
      json numbers;
      const Pose pose = poses.at(each.pose);
      for (int i = 0; i < 12; ++i)
        numbers.push_back(pose(i / 4, i % 4));
      plan["planted"].push_back({{"pose", numbers}, {"fault", each.fault}});
    }
    const std::string name = "plan" + std::to_string(sleep_us) + ".json";
    write(name, plan.dump());
    return "'" GRAZE_PLANTED_ENGINE "' '" + (folder_ / name).string() + "'";
  }

  static std::vector<std::string> command(const std::string& query, std::size_t count,
                                          const std::string& engine,
                                          const std::vector<std::string>& more) {
    std::vector<std::string> all = {"compare",
                                    "a.off",
                                    "b.off",
                                    "--query",
                                    query,
                                    "--json",
                                    "--engines",
                                    "graze",
                                    "--random",
                                    std::to_string(count),
                                    "--keep",
                                    "0",
                                    "--timeout",
                                    "4",
                                    "--threads",
                                    "2",
                                    "--engine-command",
                                    engine};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// The summary of the last line, without times.
  static json summary_of(const CommandResult& result) {
    const std::size_t at = result.out.rfind("{\"summary\"");
    if (at == std::string::npos) return result.err;
    json summary = json::parse(result.out.substr(at, result.out.find('\n', at) - at))["summary"];
    for (json& engine : summary) {
      engine.erase("median_us");
      engine.erase("total_us");
    }
    return summary;
  }

  /// Which poses the engine is wrong about, as the lines of a run say.
  static std::vector<std::size_t> wrong_poses(const CommandResult& result) {
    std::vector<std::size_t> wrong;
    for (const std::string& line : lines_of(result.out)) {
      if (line.find("\"verdict\":\"wrong\"") == std::string::npos) continue;
      const json pose = json::parse(line);
      EXPECT_EQ(pose["answers"][0]["engine"], "graze");
      EXPECT_NE(pose["answers"][0]["verdict"], "wrong") << line;
      wrong.push_back(pose["pose"]);
    }
    return wrong;
  }

  /// Whether a record has more than its first line: some poses are done.
  bool has_poses(const std::string& record) const {
    std::ifstream file(folder_ / record);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return std::count(text.begin(), text.end(), '\n') >= 2;
  }

  /// A part that is killed once its record has poses.
  void run_part_killed(const std::vector<std::string>& command, const std::string& record) const {
    const CommandResult killed = interrupt_graze(
        folder_, command, [&] { return has_poses(record); }, SIGKILL);
    EXPECT_EQ(killed.exit_code, -1) << "it was to be killed in the middle: " << killed.err;
    EXPECT_TRUE(has_poses(record));
  }

  /// One run, and eight parts of which one is killed: both count the same, which is returned.
  json whole_and_in_parts(const std::string& query, std::size_t count,
                          const std::vector<Planted>& planted, int sleep_us) {
    const auto poses = this->poses(count);
    const std::string quick = engine(*poses, planted, 0);
    const std::string slow = engine(*poses, planted, sleep_us);
    const CommandResult whole = run_graze(folder_, command(query, count, quick, {}));
    EXPECT_EQ(whole.exit_code, 0) << whole.err;
    std::vector<std::size_t> places;
    for (const Planted& each : planted)
      places.push_back(each.pose);
    EXPECT_EQ(wrong_poses(whole), places);
    const std::size_t killed = 1 + planted.front().pose * kParts / count;
    std::vector<std::string> merge = {"merge", "--json"};
    for (std::size_t part = 1; part <= kParts; ++part) {
      const std::string record = "part" + std::to_string(part);
      const std::vector<std::string> more = {
          "--part", std::to_string(part) + "/" + std::to_string(kParts), "--resume", record};
      if (part == killed) run_part_killed(command(query, count, slow, more), record);
      const CommandResult result = run_graze(folder_, command(query, count, quick, more));
      EXPECT_EQ(result.exit_code, 0) << result.err;
      merge.push_back(record);
    }
    const CommandResult merged = run_graze(folder_, merge);
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_EQ(summary_of(merged), summary_of(whole));
    return summary_of(whole);
  }

  /// The engine's line of the summary has these counts, and no others.
  static void expect_counts(const json& summary, std::size_t answers, std::size_t real,
                            std::size_t engine_errors) {
    ASSERT_EQ(summary.size(), 2u) << summary;
    EXPECT_EQ(summary[0]["engine"], "graze");
    EXPECT_EQ(summary[0]["answers"], answers);
    EXPECT_EQ(summary[0]["wrong"], 0);
    const json& engine = summary[1];
    EXPECT_EQ(engine["engine"], "planted");
    EXPECT_EQ(engine["answers"], answers);
    EXPECT_EQ(engine["wrong"], real + engine_errors);
    EXPECT_EQ(engine["real"], real);
    EXPECT_EQ(engine["engine_error"], engine_errors);
    for (const char* none : {"touching", "pose_rounding", "coplanar", "degenerate", "not_least",
                             "containment", "not_confirmed"})
      EXPECT_EQ(engine[none], 0) << none;
  }

  /// One missed hit, a crash and a hang among so many answers.
  void find_one_among(std::size_t count, int sleep_us) {
    place(make_torus(1, 0.25, 24, 16), make_sphere(0.5, 12, 18));
    const auto poses = this->poses(count);
    const auto is_hit = [&](const Pose& pose) { return intersects({*a_}, {*b_, pose}); };
    const std::vector<Planted> planted = {
        {pose_where(*poses, count * 5 / 16, is_hit), "miss"},
        {pose_where(*poses, count / 2, is_hit), "crash"},
        {pose_where(*poses, count - 200, [&](const Pose& pose) { return !is_hit(pose); }), "hang"}};
    const json summary = whole_and_in_parts("any", count, planted, sleep_us);
    expect_counts(summary, count, 1, 2);
    EXPECT_EQ(summary[1]["not_judged"], 0);
  }

  std::optional<Mesh> a_;
  std::optional<Mesh> b_;
};

TEST_F(PlantedEngine, OneMissedHitACrashAndAHangAmongThousandsAreCounted) {
  find_one_among(16'000, 1500);
}

class PlantedEngineSlow : public PlantedEngine {};

TEST_F(PlantedEngineSlow, OneMissedHitACrashAndAHangAmongAMillionAreCounted) {
  find_one_among(1'000'000, 30);
}

TEST_F(PlantedEngine, APicometreInOneDistanceIsCounted) {
  constexpr std::size_t kCount = 400;
  place(make_torus(1, 0.25, 10, 8), make_box({0.5, 0.5, 0.5}));
  const auto poses = this->poses(kCount);
  const std::size_t pose = pose_where(*poses, 160, [&](const Pose& each) {
    return distance({*a_}, {*b_, each}).distance > 0;
  });
  const json summary = whole_and_in_parts("distance", kCount, {{pose, "picometre"}}, 100'000);
  expect_counts(summary, kCount, 1, 0);
  EXPECT_EQ(summary[1]["not_judged"], 0);
  EXPECT_NEAR(summary[1]["largest_error"].get<double>(), 1e-12, 1e-15);
}

TEST_F(PlantedEngine, OneReversedNormalIsCounted) {
  constexpr std::size_t kCount = 400;
  place(make_box({0.5, 0.75, 0.25}), make_box({0.5, 0.5, 0.5}));
  const auto poses = this->poses(kCount);
  const std::size_t pose = pose_where(*poses, 160, [&](const Pose& each) {
    return intersects({*a_}, {*b_, each});
  });
  // Of normals that are not the deepest contact's nothing is judged, and nothing is wrong.
  const json summary = whole_and_in_parts("contacts", kCount, {{pose, "reverse"}}, 100'000);
  expect_counts(summary, kCount, 1, 0);
}

}  // namespace
}  // namespace graze::tests
