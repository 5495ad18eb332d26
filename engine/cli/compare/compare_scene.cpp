#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/compare_run.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/compare/recorded_run.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/reports/table.h>
#include <graze/engine/compare/run/job_key.h>
#include <graze/engine/compare/run/scene_comparison.h>
#include <graze/engine/files/source.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>

namespace graze::cli {
namespace {

using cases::json_string;
using compare::AnswerRecord;
using compare::SceneComparisonSettings;
using compare::StepRecord;
using compare::Verdict;
using compare::WrongAnswer;

constexpr std::size_t kMostDifferences = 40;

void check_scene_options(const CompareOptions& options) {
  const bool has_poses = !options.pose_a.empty() || !options.pose_b.empty() || options.poses ||
                         options.random > 0 || options.grazing > 0 || options.seed;
  if (!options.part.empty() || !options.answers.empty()) {
    throw UsageError("--part and --answers belong to two meshes");
  }
  if (has_poses)
    throw UsageError("a scene says itself where bodies are: poses belong to two meshes");
  if (options.query == "any") {
    if (options.clearance < 0) return;
    throw UsageError("--clearance belongs to --query within, first_contact and free");
  }
  if (options.query != "first_contact" && options.query != "free") {
    throw UsageError(
        "--query: of a scene each pair is asked any, at each step, or first_contact or free, on "
        "the way there");
  }
}

SceneComparisonSettings settings_of(const CompareOptions& options, const Scene& scene) {
  SceneComparisonSettings settings{.steps = options.steps.value_or(scene.steps),
                                   .step = options.step > 0 ? options.step : scene.step,
                                   .clearance = std::max(options.clearance, 0.0)};
  if (options.query == "first_contact") settings.ask = Ask::FirstContact;
  if (options.query == "free") settings.ask = Ask::Free;
  return settings;
}

std::string name_of_place(const Scene& scene, std::size_t step, const ScenePair& pair) {
  return fmt::format("{}: {}, {}", step, scene.bodies[pair.a].name, scene.bodies[pair.b].name);
}

/// Returns the span from the step before to that of the record; for step 0 it is a moment.
compare::TimeSpan span_of(const StepRecord& record, const SceneComparisonSettings& settings) {
  const std::size_t before = std::max<std::size_t>(record.place, 1) - 1;
  return {.from = static_cast<double>(before) * settings.step, .to = record.time};
}

std::vector<WrongAnswer> wrong_of_step(const std::string& file, const Scene& scene,
                                       const SceneComparisonSettings& settings,
                                       const StepRecord& record) {
  const std::string scene_name = name_part(std::filesystem::path(file).stem().string());
  std::vector<WrongAnswer> wrong;
  for (const compare::SceneDifference& difference : record.differences) {
    for (const AnswerRecord& answer : difference.answers) {
      if (!answer.is_wrong()) continue;
      const ScenePair& pair = difference.pair;
      wrong.push_back({.place = record.place,
                       .where = name_of_place(scene, record.place, pair),
                       .name = fmt::format("{}-{}-{}-step{}-{}-{}", scene_name,
                                           name_part(answer.engine), name_of(settings.ask),
                                           record.place, name_part(scene.bodies[pair.a].name),
                                           name_part(scene.bodies[pair.b].name)),
                       .answer = std::make_shared<const AnswerRecord>(answer),
                       .query = [&scene, &settings, pair, span = span_of(record, settings)] {
                         return compare::case_of(scene, pair, settings, span);
                       }});
    }
  }
  return wrong;
}

/// Holds a difference and its step.
struct Place {
  const StepRecord* record;
  const compare::SceneDifference* difference;
};

/// Makes the table of the first differences, as they come.
class DifferenceRows {
 public:
  DifferenceRows(const Scene& scene, Ask ask) : scene_(scene), table_(table_for(ask)) {}

  void add(const Place& at) {
    if (++count_ > kMostDifferences) return;
    const ScenePair& pair = at.difference->pair;
    std::array<std::string, 3> place = {std::to_string(at.record->place),
                                        mesh_io::printable(scene_.bodies[pair.a].name),
                                        mesh_io::printable(scene_.bodies[pair.b].name)};
    for (const AnswerRecord& answer : at.difference->answers) {
      const compare::Judgement& judgement = answer.judgement;
      const bool is_wrong = answer.is_wrong();
      rows_ += table_.row({place[0], place[1], place[2], answer.engine, answer.brief,
                           name_of(judgement.verdict), judgement.truth,
                           is_wrong ? name_of(judgement.error_class) : "",
                           is_wrong ? fmt::format("{:.3g}", judgement.error) : ""});
      place = {};
    }
  }

  std::string text() const {
    if (count_ == 0) return "no difference\n";
    std::string out = "differences:\n" + table_.header() + rows_;
    if (count_ > kMostDifferences) {
      out += fmt::format("... and {} more\n", count_ - kMostDifferences);
    }
    return out;
  }

 private:
  static Table table_for(Ask ask) {
    const bool has_times = ask == Ask::FirstContact;
    return Table({{"step", 6},
                  {"a", 12},
                  {"b", 12},
                  {"engine", ask == Ask::Any ? 8u : 15u},
                  {"says", has_times ? 15u : 5u},
                  {"verdict", 10},
                  {"truth", 24},
                  {"why", 13},
                  {"error (m)", 10}});
  }

  const Scene& scene_;
  const Table table_;
  std::string rows_;
  std::size_t count_ = 0;
};

/// Returns yes or no as a boolean, a first contact in words.
std::string says_json(const AnswerRecord& answer, Ask ask) {
  if (ask == Ask::FirstContact) return json_string(answer.brief);
  return answer.brief == "yes" ? "true" : "false";
}

std::string json_of(const Scene& scene, const Place& place, Ask ask) {
  const ScenePair& pair = place.difference->pair;
  std::string out =
      fmt::format("{{\"step\":{},\"time\":{},\"a\":{},\"b\":{},\"answers\":[", place.record->place,
                  place.record->time, json_string(scene.bodies[pair.a].name),
                  json_string(scene.bodies[pair.b].name));
  const char* separator = "";
  for (const AnswerRecord& answer : place.difference->answers) {
    const compare::Judgement& judgement = answer.judgement;
    out += fmt::format("{}{{\"engine\":{},\"says\":{},\"verdict\":{},\"truth\":{}", separator,
                       json_string(answer.engine), says_json(answer, ask),
                       json_string(name_of(judgement.verdict)), json_string(judgement.truth));
    if (judgement.verdict == Verdict::Wrong) {
      out += fmt::format(",\"class\":{},\"error\":{},\"ulps\":{}",
                         json_string(name_of(judgement.error_class)),
                         cases::json_plain_or_infinite(judgement.error),
                         cases::json_plain_or_infinite(judgement.ulps));
    }
    out += "}";
    separator = ",";
  }
  return out + "]}\n";
}

}  // namespace

ExitCode run_compare_scene(const CompareOptions& options,
                           std::span<const compare::EngineEntry> engines, Output& output) {
  check_scene_options(options);
  const std::vector<compare::EngineEntry> with_managers =
      with_more_engines(engines, compare::scene_engines(peer_settings(options)));
  const Field field(with_managers, options.engines);
  check_before(options, field.engines());
  const Scene scene = read_scene(options.mesh_a, {.mesh_folder = options.mesh_folder});
  const SceneComparisonSettings settings = settings_of(options, scene);
  check_paths(scene, static_cast<double>(settings.steps) * settings.step);
  CompareFindings findings{.title = std::filesystem::path(options.mesh_a).filename().string(),
                           .question = options.query,
                           .count = "",
                           .place = "step",
                           .summaries = {},
                           .wrong = wrong_list_of(options, field.engines())};
  Tally tally;
  DifferenceRows rows(scene, settings.ask);
  std::size_t questions = 0;
  RecordedJob<StepRecord> job = {.head = compare::head_of(options.mesh_a, scene, settings)};
  job.head.engines = compare::journal_engines(field.engines());
  job.read = [&](const cases::JsonCursor& at, std::size_t first) {
    return std::vector{
        compare::read_step_record(at, {first, settings.steps + 1}, scene.bodies.size())};
  };
  job.write = [](std::span<const StepRecord> line) { return to_json(line.front()); };
  job.run = [&](const auto& range, const auto& on_records) {
    compare_scene(scene, field.engines(), settings, range, on_records);
  };
  job.on_record = [&](const StepRecord& record) {
    questions += record.questions;
    tally.add(record);
    for (WrongAnswer& wrong : wrong_of_step(options.mesh_a, scene, settings, record))
      findings.wrong.add(std::move(wrong));
    for (const compare::SceneDifference& difference : record.differences) {
      rows.add({&record, &difference});
      if (options.is_json) findings.json += json_of(scene, {&record, &difference}, settings.ask);
    }
  };
  job.note = [&] { return tally.note(); };
  findings.changes = RecordedRun<StepRecord>(options, job).run();
  findings.count = fmt::format("{} steps, {} questions about pairs", settings.steps + 1, questions);
  findings.rows = rows.text();
  findings.summaries = tally.summaries();
  findings.asked = job.head.parts;
  return conclude(options, with_managers, field.engines(), findings, output);
}

}  // namespace graze::cli
