#pragma once

#include <graze/bvh/error.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/mesh/load_mesh.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {

using nlohmann::json;

/// A box that goes past a torus in forty poses, and answers about it, written to files.
class CliCompareAnswers : public CliCompare {
 protected:
  static constexpr int kPoses = 40;

  CliCompareAnswers() {
    options_.random = 0;
    options_.keep = 0;
    options_.is_json = true;
    std::string text;
    for (int i = 0; i < kPoses; ++i) {
      Pose pose = Pose::Identity();
      pose.translation() << 0.0625 * i, 0.03125, 0.0625;
      poses_.push_back(pose);
      text += "1 0 0 " + std::to_string(0.0625 * i) + " 0 1 0 0.03125 0 0 1 0.0625\n";
    }
    options_.poses = directory_.write("poses.txt", text);
  }

  json head(const std::string& question, const std::string& engine = "other") const {
    const auto sum = [&](const char* name) {
      return json{{"file", name}, {"sha256", files::sha256_of(read(name))}};
    };
    return {{"graze_answers", 1},   {"engine", engine},       {"version", "1"},
            {"question", question}, {"mesh_a", sum("a.off")}, {"mesh_b", sum("b.off")},
            {"poses", kPoses}};
  }

  /// What graze says in each pose.
  std::vector<json> honest(Ask ask) const {
    const Mesh a = load_mesh(options_.mesh_a);
    const Mesh b = load_mesh(options_.mesh_b);
    const auto pair = compare::make_graze_engine()->load(a, b);
    std::vector<json> lines;
    for (const Pose& pose : poses_) {
      const CaseAnswer answer = *pair->answer({.ask = ask}, Pose::Identity(), pose);
      lines.push_back({{"answer", json::parse(to_plain_json(answer))}, {"us", 12.5}});
    }
    return lines;
  }

  std::string written(const json& head, const std::vector<json>& lines,
                      const std::string& name = "answers.jsonl") const {
    std::string text = head.dump() + "\n";
    for (const json& line : lines)
      text += line.dump() + "\n";
    return directory_.write(name, text);
  }

  static std::vector<EngineEntry> graze_alone() {
    std::vector<EngineEntry> engines;
    engines.push_back({"graze", compare::make_graze_engine()});
    return engines;
  }

  /// What the summary says of an engine.
  json summary_of(const std::string& engine) const {
    const std::size_t at = out_.rfind("{\"summary\"");
    const json last = json::parse(out_.substr(at, out_.find('\n', at) - at));
    for (const json& each : last["summary"])
      if (each["engine"] == engine) return each;
    return {};
  }

  json judged(const std::string& query, const std::string& file,
              const std::string& engine = "other") {
    options_.query = query;
    options_.answers = {file};
    EXPECT_EQ(compare(graze_alone()), ExitCode::Answered) << out_;
    return summary_of(engine);
  }

  std::string refusal(const std::string& query, const std::string& file) {
    options_.query = query;
    options_.answers = {file};
    out_.clear();
    try {
      compare(graze_alone());
    } catch (const Error& error) {
      EXPECT_EQ(out_, "");
      return error.what();
    }
    return "none";
  }

  std::vector<Pose> poses_;
};

}  // namespace graze::cli
