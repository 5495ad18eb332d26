#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/compare_run.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/compare/recorded_run.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/replay_run.h>
#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/compare/run/job_key.h>

#include <fmt/format.h>
#include <filesystem>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;
using cases::json_string;
using compare::CaseJob;
using compare::PlaceRecord;
using compare::WrongAnswer;

void check_folder_options(const CompareOptions& options) {
  const bool has_others = !options.pose_a.empty() || !options.pose_b.empty() || options.poses ||
                          options.random > 0 || options.grazing > 0 || options.seed ||
                          options.query != "any" || options.clearance >= 0 || options.steps ||
                          options.step > 0;
  if (!has_others) return;
  throw UsageError(
      "cases say themselves what is asked: poses, --query, --clearance, --steps and --dt are not "
      "meant for a folder of them");
}

/// All cases are read before the first is asked.
CaseJob read_job(const CompareOptions& options, const std::vector<fs::path>& files) {
  CaseJob job{.cases = {}, .threads = options.threads};
  job.cases.reserve(files.size());
  CaseMeshes meshes;
  for (const fs::path& file : files) {
    job.cases.push_back({file.filename().string(),
                         read_case(file, {.mesh_folder = options.mesh_folder, .meshes = &meshes})});
  }
  return job;
}

/// The line of a record, with the names that stand for its number.
std::string named_line(const CaseJob& job, const PlaceRecord& record) {
  const compare::NamedCase& each = job.cases[record.place];
  return fmt::format("{{\"case\":{},\"file\":{},\"question\":{},\"answers\":{}}}\n", record.place,
                     json_string(each.name), json_string(name_of(each.query.ask)),
                     to_json(record.answers));
}

}  // namespace

ExitCode run_compare_folder(const CompareOptions& options,
                            std::span<const compare::EngineEntry> engines, Output& output) {
  check_folder_options(options);
  const Field field(engines, options.engines);
  check_before(options, field.engines());
  const std::vector<fs::path> files = case_files({options.mesh_a});
  const CaseJob job = read_job(options, files);
  const RecordedJob<PlaceRecord> recorded = {
      .head = compare::head_of(job),
      .read =
          [&](const cases::JsonCursor& at) {
            return compare::read_place_record(at, "case", job.cases.size());
          },
      .write = [](const PlaceRecord& record) { return to_json(record, "case"); },
      .run =
          [&](const auto& is_done, const auto& on_record) {
            compare_cases(job, field.engines(), is_done, on_record);
          }};
  const RecordedRun<PlaceRecord> run = run_recorded(options, recorded, field.engines());
  const std::size_t count = run.records.size();
  CompareFindings findings{.title = fs::path(options.mesh_a).lexically_normal().string(),
                           .question = "",
                           .count = fmt::format("{} case{}", count, count == 1 ? "" : "s"),
                           .place = "case",
                           .summaries = summarise(run.records),
                           .wrong = wrong_answers(run.records),
                           .difference = run.difference,
                           .asked = recorded.head.parts};
  for (const compare::NamedCase& each : job.cases)
    findings.names.push_back(each.name);
  for (WrongAnswer& wrong : findings.wrong) {
    const fs::path& file = files[wrong.place];
    wrong.where = findings.names[wrong.place];
    wrong.name =
        fmt::format("{}-{}-{}", name_part(file.stem().string()), name_part(wrong.answer->engine),
                    name_of(job.cases[wrong.place].query.ask));
    wrong.origin = file.string();
    wrong.query = [&job, place = wrong.place] { return job.cases[place].query; };
  }
  findings.rows = wrong_rows(findings.wrong, findings.place);
  for (const PlaceRecord& record : run.records)
    findings.json += named_line(job, record);
  return conclude(options, engines, field.engines(), findings, output);
}

}  // namespace graze::cli
