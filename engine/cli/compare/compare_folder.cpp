#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/compare_run.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/compare/recorded_run.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/case_list.h>
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
                          options.step > 0 || !options.part.empty() || !options.answers.empty();
  if (!has_others) return;
  throw UsageError(
      "cases say themselves what is asked: poses, --query, --clearance, --steps, --dt, --part and "
      "--answers are not meant for them");
}

/// Holds cases with the files that they are alone in, if they are.
struct FolderJob {
  CaseJob job;
  std::vector<fs::path> files;
};

/// Reads all cases before the first is asked.
FolderJob read_job(const CompareOptions& options) {
  FolderJob read;
  CaseMeshes meshes;
  for (const fs::path& file : case_files({options.mesh_a})) {
    read_listed_cases(
        file, {.mesh_folder = options.mesh_folder, .meshes = &meshes},
        [&](ListedCase each) {
          read.job.cases.push_back(
              {fs::path(each.name).filename().string(), std::move(each.query)});
          read.files.push_back(std::move(each.file));
        },
        [](const Error& error) { throw CaseError(error.what(), error.place()); });
  }
  return read;
}

/// Returns the line of a record, with the names that stand for its number.
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
  const FolderJob read = read_job(options);
  const auto& job = read.job;
  const auto& files = read.files;
  CompareFindings findings{.title = fs::path(options.mesh_a).lexically_normal().string(),
                           .question = "",
                           .count = "",
                           .place = "case",
                           .summaries = {},
                           .wrong = wrong_list_of(options, field.engines())};
  for (const compare::NamedCase& each : job.cases)
    findings.names.push_back(each.name);
  Tally tally;
  const auto add = [&](const PlaceRecord& record) {
    tally.add(record);
    if (options.is_json) findings.json += named_line(job, record);
    for (WrongAnswer& wrong : wrong_answers(record)) {
      wrong.where = findings.names[wrong.place];
      wrong.name =
          fmt::format("{}-{}-{}", name_part(fs::path(wrong.where).stem().string()),
                      name_part(wrong.answer->engine), name_of(job.cases[wrong.place].query.ask));
      wrong.origin = files[wrong.place].string();
      wrong.query = [&job, place = wrong.place] { return job.cases[place].query; };
      findings.wrong.add(std::move(wrong));
    }
  };
  RecordedJob<PlaceRecord> recorded = {.head = compare::head_of(job)};
  recorded.head.engines = compare::journal_engines(field.engines());
  recorded.read = [&](const cases::JsonCursor& at, std::size_t first) {
    return std::vector{compare::read_place_record(at, "case", {first, job.cases.size()})};
  };
  recorded.write = [](std::span<const PlaceRecord> line) { return to_json(line.front(), "case"); };
  recorded.run = [&](const auto& range, const auto& on_records) {
    compare_cases(job, field.engines(), range, on_records);
  };
  recorded.on_record = add;
  recorded.note = [&] { return tally.note(); };
  findings.changes = RecordedRun<PlaceRecord>(options, recorded).run();
  const std::size_t count = job.cases.size();
  findings.count = fmt::format("{} case{}", count, count == 1 ? "" : "s");
  findings.summaries = tally.summaries();
  findings.asked = recorded.head.parts;
  findings.rows = wrong_rows(findings.wrong.kept(), findings.wrong.count(), findings.place);
  return conclude(options, engines, field.engines(), findings, output);
}

}  // namespace graze::cli
