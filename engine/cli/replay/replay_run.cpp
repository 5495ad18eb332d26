#include <graze/bvh/error.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/cli/replay/fail_on.h>
#include <graze/engine/cli/replay/replay_report.h>
#include <graze/engine/cli/replay/replay_run.h>
#include <graze/engine/compare/run/shared_loads.h>
#include <graze/engine/files/source.h>

#include <cstdio>
#include <utility>

namespace graze::cli {

namespace fs = std::filesystem;

namespace {

void name_refused(const std::string& message) {
  std::fprintf(stderr, "graze: %s\n", mesh_io::printable(message).c_str());
}

ExitCode exit_code_of(const ReplayReport& report, const ReplayOptions& options, bool is_all_read) {
  if (!is_all_read) return ExitCode::BadInput;
  const bool is_failure = report.is_graze_wrong() || report.has_changed_unjudged() ||
                          (options.is_change_failure && report.has_changed()) ||
                          report.failures() > 0;
  return is_failure ? ExitCode::GrazeWrong : ExitCode::Answered;
}

}  // namespace

ExitCode run_replay(const ReplayOptions& options, std::span<const compare::EngineEntry> engines,
                    Output& output) {
  std::vector<ListedCase> cases;
  std::vector<std::string> refusals;
  CaseMeshes meshes;
  for (const fs::path& file : case_files(options.files)) {
    read_listed_cases(
        file, {.mesh_folder = options.mesh_folder, .meshes = &meshes},
        [&](ListedCase each) { cases.push_back(std::move(each)); },
        [&](const Error& error) { refusals.emplace_back(error.what()); });
  }
  if (cases.empty() && refusals.size() == 1) throw CaseError(refusals.front());
  for (const std::string& refusal : refusals)
    name_refused(refusal);
  if (cases.empty()) return ExitCode::BadInput;

  std::vector<std::string> recorded_engines;
  for (const ListedCase& each : cases)
    if (each.query.answer) recorded_engines.push_back(each.query.answered_by.engine);
  const FailOn fail_on(options.fail_on, engines, recorded_engines);
  if (fail_on.names_changes()) {
    throw UsageError("--fail-on: of what has changed see --same; others are held against a record");
  }
  Progress progress("cases:", cases.size(), {.is_forced = options.has_progress});
  ReplayReport report(output, fail_on, options.is_json);
  report.begin(engines);
  const compare::SharedLoads shared(engines);
  bool is_all_read = refusals.empty();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string& file = cases[i].name;
    std::vector<compare::Testimony> testimonies;
    try {
      testimonies = compare::try_case(cases[i].query, shared.engines());
    } catch (const Error& error) {  // then graze refuses the question
      name_refused(file + ": " + error.what());
      is_all_read = false;
      continue;
    }
    report.add(file, cases[i].query, testimonies);
    progress.update(i + 1);
  }
  report.end();
  return exit_code_of(report, options, is_all_read);
}

}  // namespace graze::cli
