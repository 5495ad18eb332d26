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
#include <filesystem>

namespace graze::cli {
namespace {

using cases::json_string;
using compare::AnswerRecord;
using compare::StepRecord;
using compare::Verdict;
using compare::WrongAnswer;

constexpr std::size_t kMostDifferences = 40;

void check_scene_options(const CompareOptions& options) {
  const bool has_poses = !options.pose_a.empty() || !options.pose_b.empty() || options.poses ||
                         options.random > 0 || options.grazing > 0 || options.seed;
  if (has_poses || options.query != "any" || options.clearance >= 0) {
    throw UsageError(
        "of a scene each pair is asked whether it touches: poses and --query belong to two meshes");
  }
}

std::string name_of_place(const Scene& scene, std::size_t step, const ScenePair& pair) {
  return fmt::format("{}: {}, {}", step, scene.bodies[pair.a].name, scene.bodies[pair.b].name);
}

std::vector<WrongAnswer> wrong_answers(const std::string& file, const Scene& scene,
                                       std::span<const StepRecord> records) {
  const std::string scene_name = name_part(std::filesystem::path(file).stem().string());
  std::vector<WrongAnswer> wrong;
  for (const StepRecord& record : records) {
    for (const compare::SceneDifference& difference : record.differences) {
      for (const AnswerRecord& answer : difference.answers) {
        if (!answer.is_wrong()) continue;
        const ScenePair& pair = difference.pair;
        wrong.push_back(
            {.place = record.place,
             .where = name_of_place(scene, record.place, pair),
             .name = fmt::format("{}-{}-any-step{}-{}-{}", scene_name, name_part(answer.engine),
                                 record.place, name_part(scene.bodies[pair.a].name),
                                 name_part(scene.bodies[pair.b].name)),
             .answer = &answer,
             .query = [&scene, pair, time = record.time] {
               return compare::case_of(scene, pair, time);
             }});
      }
    }
  }
  return wrong;
}

/// A difference and its step.
struct Place {
  const StepRecord* record;
  const compare::SceneDifference* difference;
};

std::vector<Place> places_of(std::span<const StepRecord> records) {
  std::vector<Place> places;
  for (const StepRecord& record : records) {
    for (const compare::SceneDifference& difference : record.differences)
      places.push_back({&record, &difference});
  }
  return places;
}

std::string rows_of(const Scene& scene, std::span<const StepRecord> records) {
  const std::vector<Place> places = places_of(records);
  if (places.empty()) return "no difference\n";
  const Table table({{"step", 6},
                     {"a", 12},
                     {"b", 12},
                     {"engine", 8},
                     {"says", 5},
                     {"verdict", 10},
                     {"truth", 24},
                     {"why", 13},
                     {"error (m)", 10}});
  std::string out = "differences:\n" + table.header();
  for (std::size_t i = 0; i < std::min(places.size(), kMostDifferences); ++i) {
    const ScenePair& pair = places[i].difference->pair;
    std::array<std::string, 3> place = {std::to_string(places[i].record->place),
                                        mesh_io::printable(scene.bodies[pair.a].name),
                                        mesh_io::printable(scene.bodies[pair.b].name)};
    for (const AnswerRecord& answer : places[i].difference->answers) {
      const compare::Judgement& judgement = answer.judgement;
      const bool is_wrong = answer.is_wrong();
      out += table.row({place[0], place[1], place[2], answer.engine, answer.brief,
                        name_of(judgement.verdict), judgement.truth,
                        is_wrong ? name_of(judgement.error_class) : "",
                        is_wrong ? fmt::format("{:.3g}", judgement.error) : ""});
      place = {};
    }
  }
  if (places.size() > kMostDifferences) {
    out += fmt::format("... and {} more\n", places.size() - kMostDifferences);
  }
  return out;
}

std::string json_of(const Scene& scene, const Place& place) {
  const ScenePair& pair = place.difference->pair;
  std::string out =
      fmt::format("{{\"step\":{},\"time\":{},\"a\":{},\"b\":{},\"answers\":[", place.record->place,
                  place.record->time, json_string(scene.bodies[pair.a].name),
                  json_string(scene.bodies[pair.b].name));
  const char* separator = "";
  for (const AnswerRecord& answer : place.difference->answers) {
    const compare::Judgement& judgement = answer.judgement;
    out += fmt::format("{}{{\"engine\":{},\"says\":{},\"verdict\":{},\"truth\":{}", separator,
                       json_string(answer.engine), answer.brief == "yes",
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
  const Field field(engines, options.engines);
  check_before(options, field.engines());
  const Scene scene = read_scene(options.mesh_a, {.mesh_folder = options.mesh_folder});
  const compare::SceneComparisonSettings settings{.steps = options.steps.value_or(scene.steps),
                                                  .step = options.step,
                                                  .threads = options.threads};
  check_paths(scene, static_cast<double>(settings.steps) *
                         (settings.step > 0 ? settings.step : scene.step));
  const RecordedJob<StepRecord> job = {
      .head = compare::head_of(options.mesh_a, scene, settings),
      .read =
          [&](const cases::JsonCursor& at) {
            return compare::read_step_record(at, settings.steps + 1, scene.bodies.size());
          },
      .write = [](const StepRecord& record) { return to_json(record); },
      .run =
          [&](const auto& is_done, const auto& on_record) {
            compare_scene(scene, field.engines(), settings, is_done, on_record);
          }};
  const RecordedRun<StepRecord> run = run_recorded(options, job, field.engines());
  std::size_t questions = 0;
  for (const StepRecord& record : run.records)
    questions += record.questions;
  CompareFindings findings{
      .title = std::filesystem::path(options.mesh_a).filename().string(),
      .question = "any",
      .count = fmt::format("{} steps, {} questions about pairs", run.records.size(), questions),
      .place = "step",
      .rows = rows_of(scene, run.records),
      .summaries = summarise(run.records),
      .wrong = wrong_answers(options.mesh_a, scene, run.records),
      .difference = run.difference,
      .asked = job.head.parts};
  for (const Place& place : places_of(run.records))
    findings.json += json_of(scene, place);
  return conclude(options, engines, field.engines(), findings, output);
}

}  // namespace graze::cli
