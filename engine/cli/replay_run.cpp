#include <graze/engine/cases/read_case.h>
#include <graze/engine/cli/progress.h>
#include <graze/engine/cli/replay_report.h>
#include <graze/engine/cli/replay_run.h>
#include <graze/engine/mesh/io/source.h>

#include <algorithm>

namespace graze::cli {

namespace fs = std::filesystem;

std::vector<fs::path> case_files(const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const std::string& argument : arguments) {
    std::error_code ignored;
    if (!fs::is_directory(argument, ignored)) {
      files.emplace_back(argument);
      continue;
    }
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(argument)) {
      if (entry.path().extension() == ".json") found.push_back(entry.path());
    }
    if (found.empty()) {
      throw CaseError(mesh_io::printable(argument) + ": holds no case, no file that ends in .json");
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

ExitCode run_replay(const ReplayOptions& options, std::span<const compare::EngineEntry> engines,
                    Output& output) {
  const std::vector<fs::path> files = case_files(options.files);
  std::vector<Case> cases;
  cases.reserve(files.size());
  for (const fs::path& file : files)
    cases.push_back(read_case(file, {.mesh_folder = options.mesh_folder}));

  Progress progress("cases:", cases.size(), {.is_forced = options.has_progress});
  ReplayReport report(output, options.is_json);
  report.begin(engines);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    report.add(files[i].string(), cases[i], compare::try_case(cases[i], engines));
    progress.update(i + 1);
  }
  report.end();
  return report.is_graze_wrong() ? ExitCode::GrazeWrong : ExitCode::Answered;
}

}  // namespace graze::cli
