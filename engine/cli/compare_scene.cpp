#include <graze/engine/cases/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/compare_report.h>
#include <graze/engine/cli/compare_scene.h>
#include <graze/engine/cli/engine_field.h>
#include <graze/engine/cli/progress.h>
#include <graze/engine/cli/table.h>
#include <graze/engine/cli/usage_error.h>
#include <graze/engine/compare/run/scene_comparison.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/mesh/io/source.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>

#include <fmt/format.h>
#include <array>
#include <filesystem>

namespace graze::cli {
namespace {

using cases::json_string;
using compare::AnswerRecord;
using compare::Verdict;

constexpr std::size_t kMostDifferences = 40;

/// A pair at a step of which not all engines said the same.
struct Difference {
  std::size_t step;
  double time;
  ScenePair pair;
  std::vector<AnswerRecord> answers;
};

struct Found {
  Summaries summaries;
  std::vector<Difference> differences;
  std::size_t compared = 0;
  bool is_graze_wrong = false;
};

void check_options(const CompareOptions& options) {
  const bool has_poses = !options.pose_a.empty() || !options.pose_b.empty() || options.poses ||
                         options.random > 0 || options.grazing > 0;
  const bool has_others = has_poses || options.query != "any" || options.clearance >= 0 ||
                          !options.save.empty() || !options.against.empty() ||
                          !options.resume.empty() || !options.report.empty();
  if (!has_others) return;
  throw UsageError(
      "of a scene each pair is asked whether it touches: poses, --query, --save, --against, "
      "--resume "
      "and --report belong to two meshes");
}

bool is_graze(const AnswerRecord& answer) {
  return answer.engine == "graze" || answer.engine == "world";
}

Found run_all(const Scene& scene, std::span<const compare::EngineEntry> engines,
              const compare::SceneComparisonSettings& settings, bool has_progress) {
  Found found;
  Progress progress("steps:", settings.steps + 1, {.is_forced = has_progress});
  compare_scene(scene, engines, settings, [&](const compare::SceneRecord& record) {
    ++found.compared;
    for (const AnswerRecord& answer : record.answers) {
      found.summaries.add(answer);
      found.is_graze_wrong = found.is_graze_wrong || (is_graze(answer) && answer.is_wrong());
    }
    if (!record.answers.front().is_agreed) {
      found.differences.push_back(
          {record.step, record.time, record.pair, {record.answers.begin(), record.answers.end()}});
    }
    progress.update(record.step);
  });
  progress.update(settings.steps + 1);
  return found;
}

/// Of two meshes a difference is shrunk, as it is without a scene.
std::vector<WrittenCase> write_cases(const CompareOptions& options, const Scene& scene,
                                     std::span<const compare::EngineEntry> engines,
                                     const Found& found) {
  std::vector<WrittenCase> written;
  if (options.cases.empty()) return written;
  const auto is_mesh = [&](std::size_t body) {
    return scene.shapes[scene.bodies[body].shape].shape.kind() == ShapeKind::Mesh;
  };
  const std::filesystem::path folder = options.cases;
  for (const Difference& difference : found.differences) {
    if (!is_mesh(difference.pair.a) || !is_mesh(difference.pair.b)) continue;
    const std::vector<compare::PoseRecord> records = {{0, difference.answers}};
    const compare::ComparisonJob job = compare::mesh_job(scene, difference.pair, difference.time);
    for (compare::ShrunkCase& each : shrink_worst(job, engines, records, options.keep)) {
      if (written.size() == options.keep) return written;
      each.pose = difference.step;
      each.query.note = fmt::format(
          "{}, step {}, {} and {}: {} says {}, the truth is: {} ({})",
          std::filesystem::path(options.mesh_a).filename().string(), difference.step,
          scene.bodies[difference.pair.a].name, scene.bodies[difference.pair.b].name, each.engine,
          each.query.answer ? compare::brief(*each.query.answer) : "nothing", each.judgement.truth,
          name_of(each.judgement.error_class));
      std::error_code error;
      std::filesystem::create_directories(folder, error);
      const std::filesystem::path file =
          folder / fmt::format("{}-step{}-{}-{}.json", each.engine, difference.step,
                               difference.pair.a, difference.pair.b);
      write_case(file, each.query);
      written.push_back({std::move(each), file.string()});
    }
  }
  return written;
}

std::string rows_of(const Scene& scene, const Found& found) {
  if (found.differences.empty()) return "no difference\n";
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
  std::size_t count = 0;
  for (const Difference& difference : found.differences) {
    if (++count > kMostDifferences) continue;
    std::array<std::string, 3> place = {std::to_string(difference.step),
                                        mesh_io::printable(scene.bodies[difference.pair.a].name),
                                        mesh_io::printable(scene.bodies[difference.pair.b].name)};
    for (const AnswerRecord& answer : difference.answers) {
      const compare::Judgement& judgement = answer.judgement;
      const bool is_wrong = answer.is_wrong();
      out += table.row({place[0], place[1], place[2], answer.engine, answer.brief,
                        name_of(judgement.verdict), judgement.truth,
                        is_wrong ? name_of(judgement.error_class) : "",
                        is_wrong ? fmt::format("{:.3g}", judgement.error) : ""});
      place = {};
    }
  }
  if (count > kMostDifferences) out += fmt::format("... and {} more\n", count - kMostDifferences);
  return out;
}

std::string json_of(const Scene& scene, const Difference& difference) {
  std::string out =
      fmt::format("{{\"step\":{},\"time\":{},\"a\":{},\"b\":{},\"answers\":[", difference.step,
                  difference.time, json_string(scene.bodies[difference.pair.a].name),
                  json_string(scene.bodies[difference.pair.b].name));
  const char* separator = "";
  for (const AnswerRecord& answer : difference.answers) {
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
  const Scene scene = read_scene(options.mesh_a, {.mesh_folder = options.mesh_folder});
  const compare::SceneComparisonSettings settings{.steps = options.steps.value_or(scene.steps),
                                                  .step = options.step};
  check_paths(scene, static_cast<double>(settings.steps) *
                         (settings.step > 0 ? settings.step : scene.step));
  const Found found = run_all(scene, field.engines(), settings, options.has_progress);
  const std::vector<WrittenCase> cases = write_cases(options, scene, field.engines(), found);
  const std::vector<EngineSummary> summaries = found.summaries.take();
  std::string text;
  if (options.is_json) {
    for (const Difference& difference : found.differences)
      text += json_of(scene, difference);
    text += summary_json(summaries, cases);
  } else {
    for (const compare::EngineEntry& entry : engines) {
      if (entry.engine == nullptr) text += entry.name + ": not found when this command was built\n";
    }
    text += rows_of(scene, found);
    for (const WrittenCase& each : cases)
      text += "shrunk: graze replay " + mesh_io::printable(each.file) + "\n";
    text += fmt::format("{} steps, {} questions about pairs\n", settings.steps + 1, found.compared);
    text += summary_text(summaries);
  }
  output.write(text);
  return found.is_graze_wrong ? ExitCode::GrazeWrong : ExitCode::Answered;
}

}  // namespace graze::cli
