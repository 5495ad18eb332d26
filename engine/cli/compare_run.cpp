#include <graze/bvh/error.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/compare_output.h>
#include <graze/engine/cli/compare_report.h>
#include <graze/engine/cli/compare_run.h>
#include <graze/engine/cli/compare_scene.h>
#include <graze/engine/cli/engine_field.h>
#include <graze/engine/cli/html_report.h>
#include <graze/engine/cli/progress.h>
#include <graze/engine/cli/replay_run.h>
#include <graze/engine/cli/usage_error.h>
#include <graze/engine/compare/run/journal.h>
#include <graze/engine/compare/run/pose_source.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/mesh/io/source.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <set>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;
using compare::ComparisonJob;
using compare::EngineEntry;
using compare::PoseRecord;

Ask ask_named(const std::string& name) {
  for (const Ask ask : {Ask::Any, Ask::Pairs, Ask::Distance, Ask::Within, Ask::Contacts}) {
    if (name == name_of(ask)) return ask;
  }
  throw UsageError("--query: there is no question " + mesh_io::quoted(name));
}

void check_combinations(const CompareOptions& options) {
  if (options.steps || options.step > 0 || !options.mesh_folder.empty()) {
    throw UsageError("--steps, --dt and --meshes belong to scenes");
  }
  const int sources = !options.pose_b.empty() + options.poses.has_value() + (options.random > 0) +
                      (options.grazing > 0);
  if (sources > 1) {
    throw UsageError("--pose-b, --poses, --random and --grazing exclude each other: all place B");
  }
  if ((options.query == "within") != (options.clearance >= 0)) {
    throw UsageError("--clearance belongs to --query within");
  }
  if (!(options.time_tolerance >= 1)) throw UsageError("--time-tolerance: is below 1");
}

std::vector<Pose> poses_of(const CompareOptions& options, const PlacedMesh& a, const Mesh& b) {
  if (options.random > 0) return compare::random_poses(a, b, options.random, options.seed);
  if (options.grazing > 0) return compare::grazing_poses(a, b, options.grazing, options.seed);
  if (!options.pose_b.empty()) return {parse_pose(options.pose_b, "--pose-b")};
  if (!options.poses) return {Pose::Identity()};
  std::vector<Pose> poses;
  for (const PoseLine& line : load_pose_lines(*options.poses)) {
    const std::string place = *options.poses + ":" + std::to_string(line.line);
    check_placement(line.pose, b.bounds(), place.c_str());
    poses.push_back(line.pose);
  }
  return poses;
}

ComparisonJob read_job(const CompareOptions& options) {
  check_combinations(options);
  const Pose pose_a =
      options.pose_a.empty() ? Pose(Pose::Identity()) : parse_pose(options.pose_a, "--pose-a");
  const Mesh mesh_a = load_mesh(options.mesh_a);
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  check_placement(pose_a, mesh_a.bounds(), "--pose-a");
  ComparisonJob job{.a = CaseMesh(mesh_a, pose_a),
                    .b = CaseMesh(mesh_b, Pose::Identity()),
                    .poses_b = poses_of(options, {mesh_a, pose_a}, mesh_b),
                    .question = {ask_named(options.query), {}},
                    .threads = options.threads};
  if (options.clearance >= 0) job.question.settings.clearance = options.clearance;
  for (const Pose& pose : job.poses_b)
    check_placement(pose, mesh_b.bounds(), "the pose of B");
  return job;
}

/// Records of an earlier run of the same job.
std::vector<PoseRecord> resumed(const CompareOptions& options, const ComparisonJob& job,
                                std::span<const EngineEntry> engines) {
  std::error_code ignored;
  if (options.resume.empty() || !fs::exists(options.resume, ignored)) return {};
  compare::Journal journal = compare::read_journal(options.resume);
  check_resumed(options, journal.key == compare::key_of(job), journal.engines, engines);
  std::set<std::size_t> seen;
  std::vector<PoseRecord> records;
  for (PoseRecord& record : journal.records) {
    if (seen.insert(record.pose).second) records.push_back(std::move(record));
  }
  return records;
}

std::vector<PoseRecord> run_all(const CompareOptions& options, const ComparisonJob& job,
                                std::span<const EngineEntry> engines) {
  std::vector<PoseRecord> records = resumed(options, job, engines);
  std::vector<bool> is_done(job.poses_b.size(), false);
  for (const PoseRecord& record : records)
    is_done[record.pose] = true;
  std::optional<compare::JournalWriter> journal;
  if (!options.resume.empty()) journal.emplace(options.resume, job, engines, records);
  Progress progress("poses:", job.poses_b.size(), {.is_forced = options.has_progress});
  run_comparison(
      job, engines, [&](std::size_t pose) { return is_done[pose]; },
      [&](PoseRecord record) {
        if (journal) journal->add(record);
        records.push_back(std::move(record));
        progress.update(records.size());
      });
  std::sort(records.begin(), records.end(),
            [](const PoseRecord& a, const PoseRecord& b) { return a.pose < b.pose; });
  return records;
}

std::vector<WrittenCase> write_cases(const CompareOptions& options,
                                     std::vector<compare::ShrunkCase> shrunk) {
  std::vector<WrittenCase> written;
  if (shrunk.empty() || options.cases.empty()) return written;
  std::error_code error;
  fs::create_directories(options.cases, error);
  if (error) {
    throw UsageError("--cases: " + mesh_io::printable(options.cases) + ": " + error.message());
  }
  for (compare::ShrunkCase& each : shrunk) {
    const std::string name = fmt::format("{}-{}-{}.json", each.engine, options.query, each.pose);
    each.query.note = fmt::format(
        "{} against {}, pose {}: {} says {}, the truth is: {} ({})",
        fs::path(options.mesh_a).filename().string(), fs::path(options.mesh_b).filename().string(),
        each.pose, each.engine, each.query.answer ? compare::brief(*each.query.answer) : "nothing",
        each.judgement.truth, name_of(each.judgement.error_class));
    const fs::path file = fs::path(options.cases) / name;
    write_case(file, each.query);
    written.push_back({std::move(each), file.string()});
  }
  return written;
}

bool is_graze_wrong(std::span<const PoseRecord> records) {
  return std::any_of(records.begin(), records.end(), [](const PoseRecord& record) {
    return std::any_of(record.answers.begin(), record.answers.end(), [](const auto& answer) {
      return answer.engine == "graze" && answer.is_wrong();
    });
  });
}

/// A folder of cases, each of which says what is asked.
ExitCode run_cases(const CompareOptions& options, std::span<const EngineEntry> engines,
                   Output& output) {
  const bool has_others = !options.pose_a.empty() || !options.pose_b.empty() || options.poses ||
                          options.random > 0 || options.grazing > 0 || options.query != "any" ||
                          options.clearance >= 0 || options.steps || options.step > 0 ||
                          !options.report.empty() || !options.save.empty() ||
                          !options.against.empty() || !options.resume.empty();
  if (has_others) {
    throw UsageError(
        "cases say themselves what is asked: of a folder of them --engines, --meshes, --json and "
        "--progress are meant, and no others");
  }
  const Field field(engines, options.engines);
  return run_replay({.files = {options.mesh_a},
                     .mesh_folder = options.mesh_folder,
                     .is_json = options.is_json,
                     .has_progress = options.has_progress},
                    options.engines.empty() ? engines : field.engines(), output);
}

}  // namespace

ExitCode run_compare(const CompareOptions& options, std::span<const EngineEntry> engines,
                     Output& output) {
  if (options.mesh_b.empty()) {
    std::error_code ignored;
    if (fs::path(options.mesh_a).extension() == ".json") {
      return run_compare_scene(options, engines, output);
    }
    if (!fs::is_directory(options.mesh_a, ignored)) {
      throw UsageError("a mesh B is needed, or a folder of cases alone, or a scene, a .json file");
    }
    return run_cases(options, engines, output);
  }
  const Field field(engines, options.engines);
  check_places(options);
  const ComparisonJob job = read_job(options);
  std::optional<compare::Journal> baseline;  // bad input comes first
  if (!options.against.empty()) {
    baseline = compare::read_journal(options.against);
    check_baseline(options, baseline->key == compare::key_of(job));
  }
  const std::vector<PoseRecord> records = run_all(options, job, field.engines());
  const std::vector<WrittenCase> cases =
      write_cases(options, shrink_worst(job, field.engines(), records, options.keep));
  if (!options.save.empty()) {
    compare::JournalWriter(options.save, job, field.engines(), records);
  }
  if (!options.report.empty()) {
    const std::vector<EngineSummary> summaries = summarise(records);
    const std::vector<WrongAnswer> wrong = wrong_answers(records);
    write_report(options.report, {.mesh_a = options.mesh_a,
                                  .mesh_b = options.mesh_b,
                                  .query = options.query,
                                  .places = fmt::format("{} poses", records.size()),
                                  .place = "pose",
                                  .summaries = summaries,
                                  .wrong = wrong,
                                  .cases = cases});
  }
  std::string text;
  if (options.is_json) {
    for (const PoseRecord& record : records)
      text += to_json(record) + "\n";
    text += summary_json(summarise(records), cases);
  } else {
    for (const EngineEntry& entry : engines) {
      if (entry.engine == nullptr) text += entry.name + ": not found when this command was built\n";
    }
    text += compare_text(records, cases);
  }
  Regression regression;
  if (baseline)
    regression = regression_of(options, compare_to_baseline(*baseline, records), "poses");
  output.write(text + regression.text);
  const bool is_bad = is_graze_wrong(records) || regression.is_one;
  return is_bad ? ExitCode::GrazeWrong : ExitCode::Answered;
}

}  // namespace graze::cli
