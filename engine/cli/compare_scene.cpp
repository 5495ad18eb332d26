#include <graze/engine/cases/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/compare_output.h>
#include <graze/engine/cli/compare_report.h>
#include <graze/engine/cli/compare_scene.h>
#include <graze/engine/cli/engine_field.h>
#include <graze/engine/cli/html_report.h>
#include <graze/engine/cli/progress.h>
#include <graze/engine/cli/table.h>
#include <graze/engine/cli/usage_error.h>
#include <graze/engine/compare/run/scene_comparison.h>
#include <graze/engine/compare/run/scene_journal.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/mesh/io/source.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>

namespace graze::cli {
namespace {

using cases::json_string;
using compare::AnswerRecord;
using compare::StepRecord;
using compare::Verdict;

constexpr std::size_t kMostDifferences = 40;

void check_options(const CompareOptions& options) {
  const bool has_poses = !options.pose_a.empty() || !options.pose_b.empty() || options.poses ||
                         options.random > 0 || options.grazing > 0;
  if (has_poses || options.query != "any" || options.clearance >= 0) {
    throw UsageError(
        "of a scene each pair is asked whether it touches: poses and --query belong to two meshes");
  }
  if (!(options.time_tolerance >= 1)) throw UsageError("--time-tolerance: is below 1");
}

bool is_graze(const AnswerRecord& answer) {
  return answer.engine == "graze" || answer.engine == "world";
}

bool is_graze_wrong(const compare::SceneDifference& difference) {
  return std::any_of(
      difference.answers.begin(), difference.answers.end(),
      [](const AnswerRecord& answer) { return is_graze(answer) && answer.is_wrong(); });
}

bool is_graze_wrong(std::span<const StepRecord> records) {
  return std::any_of(records.begin(), records.end(), [](const StepRecord& record) {
    return std::any_of(record.differences.begin(), record.differences.end(),
                       [](const auto& difference) { return is_graze_wrong(difference); });
  });
}

std::string name_of_place(const Scene& scene, std::size_t step, const ScenePair& pair) {
  return fmt::format("{}: {}, {}", step, scene.bodies[pair.a].name, scene.bodies[pair.b].name);
}

std::vector<WrongAnswer> wrong_answers(const Scene& scene, std::span<const StepRecord> records) {
  std::vector<WrongAnswer> wrong;
  for (const StepRecord& record : records) {
    for (const compare::SceneDifference& difference : record.differences) {
      for (const AnswerRecord& answer : difference.answers) {
        if (!answer.is_wrong()) continue;
        wrong.push_back({name_of_place(scene, record.step, difference.pair), &answer});
      }
    }
  }
  return wrong;
}

/// Records of an earlier run of the same job.
std::vector<StepRecord> resumed(const CompareOptions& options, const Scene& scene,
                                const compare::SceneJob& job,
                                std::span<const compare::EngineEntry> engines) {
  std::error_code ignored;
  if (options.resume.empty() || !std::filesystem::exists(options.resume, ignored)) return {};
  compare::SceneJournal journal = compare::read_scene_journal(options.resume, scene);
  check_resumed(options, journal.job == job, journal.engines, engines);
  std::set<std::size_t> seen;
  std::vector<StepRecord> records;
  for (StepRecord& record : journal.records) {
    if (seen.insert(record.step).second) records.push_back(std::move(record));
  }
  return records;
}

std::vector<StepRecord> run_all(const CompareOptions& options, const Scene& scene,
                                const compare::SceneJob& job,
                                std::span<const compare::EngineEntry> engines,
                                const compare::SceneComparisonSettings& settings) {
  std::vector<StepRecord> records = resumed(options, scene, job, engines);
  std::vector<bool> is_done(job.steps, false);
  for (const StepRecord& record : records)
    is_done[record.step] = true;
  std::optional<compare::SceneJournalWriter> journal;
  if (!options.resume.empty()) journal.emplace(options.resume, job, engines, records);
  Progress progress("steps:", job.steps, {.is_forced = options.has_progress});
  compare_scene(
      scene, engines, settings, [&](std::size_t step) { return is_done[step]; },
      [&](StepRecord record) {
        if (journal) journal->add(record);
        records.push_back(std::move(record));
        progress.update(records.size());
      });
  std::sort(records.begin(), records.end(),
            [](const StepRecord& a, const StepRecord& b) { return a.step < b.step; });
  return records;
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

/// Those first in which graze is wrong.
std::vector<Place> worst_first(std::span<const StepRecord> records) {
  std::vector<Place> places = places_of(records);
  std::stable_partition(places.begin(), places.end(),
                        [](const Place& place) { return is_graze_wrong(*place.difference); });
  return places;
}

/// Of two meshes a difference is shrunk, as it is without a scene.
std::vector<WrittenCase> write_cases(const CompareOptions& options, const Scene& scene,
                                     std::span<const compare::EngineEntry> engines,
                                     std::span<const StepRecord> records) {
  std::vector<WrittenCase> written;
  if (options.cases.empty()) return written;
  const auto is_mesh = [&](std::size_t body) {
    return scene.shapes[scene.bodies[body].shape].shape.kind() == ShapeKind::Mesh;
  };
  const std::filesystem::path folder = options.cases;
  for (const auto& [record, difference] : worst_first(records)) {
    const ScenePair& pair = difference->pair;
    if (!is_mesh(pair.a) || !is_mesh(pair.b)) continue;
    const std::vector<compare::PoseRecord> answers = {{0, difference->answers}};
    const compare::ComparisonJob job = compare::mesh_job(scene, pair, record->time);
    for (compare::ShrunkCase& each :
         shrink_worst(job, engines, answers, options.keep - written.size())) {
      each.pose = record->step;
      each.query.note =
          fmt::format("{}, step {}, {} and {}: {} says {}, the truth is: {} ({})",
                      std::filesystem::path(options.mesh_a).filename().string(), record->step,
                      scene.bodies[pair.a].name, scene.bodies[pair.b].name, each.engine,
                      each.query.answer ? compare::brief(*each.query.answer) : "nothing",
                      each.judgement.truth, name_of(each.judgement.error_class));
      std::error_code error;
      std::filesystem::create_directories(folder, error);
      const std::filesystem::path file =
          folder / fmt::format("{}-step{}-{}-{}.json", each.engine, record->step, pair.a, pair.b);
      write_case(file, each.query);
      written.push_back({std::move(each), file.string()});
    }
  }
  return written;
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
    std::array<std::string, 3> place = {std::to_string(places[i].record->step),
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
      fmt::format("{{\"step\":{},\"time\":{},\"a\":{},\"b\":{},\"answers\":[", place.record->step,
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
                         cases::json_number(judgement.error), cases::json_number(judgement.ulps));
    }
    out += "}";
    separator = ",";
  }
  return out + "]}\n";
}

}  // namespace

ExitCode run_compare_scene(const CompareOptions& options,
                           std::span<const compare::EngineEntry> engines, Output& output) {
  check_options(options);
  const Field field(engines, options.engines);
  check_places(options);
  const Scene scene = read_scene(options.mesh_a, {.mesh_folder = options.mesh_folder});
  const compare::SceneComparisonSettings settings{.steps = options.steps.value_or(scene.steps),
                                                  .step = options.step,
                                                  .threads = options.threads};
  check_paths(scene, static_cast<double>(settings.steps) *
                         (settings.step > 0 ? settings.step : scene.step));
  const compare::SceneJob job = compare::scene_job(options.mesh_a, scene, settings);
  std::optional<compare::SceneJournal> baseline;  // bad input comes first
  if (!options.against.empty()) {
    baseline = compare::read_scene_journal(options.against, scene);
    check_baseline(options, baseline->job == job);
  }
  const std::vector<StepRecord> records = run_all(options, scene, job, field.engines(), settings);
  const std::vector<WrittenCase> cases = write_cases(options, scene, field.engines(), records);
  const std::vector<EngineSummary> summaries = summarise(records);
  if (!options.save.empty()) {
    compare::SceneJournalWriter(options.save, job, field.engines(), records);
  }
  if (!options.report.empty()) {
    const std::vector<WrongAnswer> wrong = wrong_answers(scene, records);
    write_report(options.report, {.mesh_a = options.mesh_a,
                                  .mesh_b = "",
                                  .query = options.query,
                                  .places = fmt::format("{} steps", records.size()),
                                  .place = "step",
                                  .summaries = summaries,
                                  .wrong = wrong,
                                  .cases = cases});
  }
  std::string text;
  if (options.is_json) {
    for (const Place& place : places_of(records))
      text += json_of(scene, place);
    text += summary_json(summaries, cases);
  } else {
    for (const compare::EngineEntry& entry : engines) {
      if (entry.engine == nullptr) text += entry.name + ": not found when this command was built\n";
    }
    text += rows_of(scene, records);
    for (const WrittenCase& each : cases)
      text += "shrunk: graze replay " + mesh_io::printable(each.file) + "\n";
    std::size_t questions = 0;
    for (const StepRecord& record : records)
      questions += record.questions;
    text += fmt::format("{} steps, {} questions about pairs\n", records.size(), questions);
    text += summary_text(summaries);
  }
  Regression regression;
  if (baseline) {
    regression = regression_of(options, compare_to_baseline(*baseline, records), "steps");
  }
  output.write(text + regression.text);
  const bool is_bad = is_graze_wrong(records) || regression.is_one;
  return is_bad ? ExitCode::GrazeWrong : ExitCode::Answered;
}

}  // namespace graze::cli
