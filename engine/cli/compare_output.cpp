#include <graze/engine/cli/compare_output.h>
#include <graze/engine/cli/usage_error.h>
#include <graze/engine/mesh/io/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <utility>

namespace graze::cli {

namespace fs = std::filesystem;

void check_places(const CompareOptions& options) {
  for (const auto& [name, file] :
       {std::pair{"--report", &options.report}, std::pair{"--save", &options.save},
        std::pair{"--resume", &options.resume}}) {
    if (file->empty()) continue;
    const fs::path folder = fs::path(*file).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored)) {
      throw UsageError(fmt::format("{}: {}: there is no folder {}", name, mesh_io::printable(*file),
                                   mesh_io::printable(folder.string())));
    }
    if (fs::is_directory(*file, ignored)) {
      throw UsageError(fmt::format("{}: {}: is a folder", name, mesh_io::printable(*file)));
    }
  }
  std::error_code ignored;
  if (fs::exists(options.cases, ignored) && !fs::is_directory(options.cases, ignored)) {
    throw UsageError("--cases: " + mesh_io::printable(options.cases) + ": is no folder");
  }
}

void check_resumed(const CompareOptions& options, bool is_same_job,
                   std::span<const std::string> engines_then,
                   std::span<const compare::EngineEntry> engines_now) {
  const std::string file = mesh_io::printable(options.resume);
  if (!is_same_job) {
    throw UsageError("--resume: " + file + " is a record of something else");
  }
  const bool are_same =
      std::equal(engines_then.begin(), engines_then.end(), engines_now.begin(), engines_now.end(),
                 [](const std::string& name, const compare::EngineEntry& entry) {
                   return name == entry.name;
                 });
  if (are_same) return;
  std::string names;
  for (const std::string& name : engines_then)
    names += (names.empty() ? "" : ",") + mesh_io::printable(name);
  throw UsageError("--resume: " + file + " is of other engines: " + names);
}

void check_baseline(const CompareOptions& options, bool is_same_job) {
  if (is_same_job) return;
  throw UsageError("--against: " + mesh_io::printable(options.against) +
                   " is a record of something else");
}

Regression regression_of(const CompareOptions& options, const compare::BaselineDifference& found,
                         std::string_view places) {
  const double ratio = found.old_time > 0 ? found.new_time / found.old_time : 1;
  const bool is_slower = ratio > options.time_tolerance;
  Regression result;
  result.is_one = !found.changed.empty() || !found.missing.empty() || is_slower;
  if (options.is_json) {
    result.text = fmt::format(
        "{{\"against\":{{\"changed\":[{}],\"missing\":[{}],\"time_ratio\":{:.3f},\"slower\":{}}}}}"
        "\n",
        fmt::join(found.changed, ","), fmt::join(found.missing, ","), ratio, is_slower);
  } else {
    const std::string where = fmt::format(" in {} {}", places, fmt::join(found.changed, " "));
    result.text = fmt::format(
        "against {}: {} answers of graze changed{}, {} missing; time {:.2f} of what it was{}\n",
        mesh_io::printable(options.against), found.changed.size(),
        found.changed.empty() ? "" : where, found.missing.size(), ratio,
        is_slower ? fmt::format(", more than {:.2f}", options.time_tolerance) : "");
  }
  return result;
}

}  // namespace graze::cli
