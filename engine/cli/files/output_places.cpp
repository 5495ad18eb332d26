#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/files/output_target.h>
#include <graze/engine/files/source.h>

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;
using files::OutputTarget;

/// True if both are one file. For a file that is not there yet the place counts. Devices are no
/// files.
bool is_same_file(const OutputTarget& output, const fs::path& other) {
  if (output.kind != OutputTarget::Kind::Replaced) return false;
  std::error_code error;
  if (output.old) return fs::equivalent(output.path, other, error) && !error;
  if (fs::exists(other, error)) return false;
  const OutputTarget there = files::find_output_target(other);
  return fs::weakly_canonical(fs::absolute(output.path), error) ==
         fs::weakly_canonical(fs::absolute(there.path), error);
}

bool is_standard_output(const OutputTarget& output) {
  struct stat status = {};
  return output.kind == OutputTarget::Kind::Replaced && output.old &&
         fstat(STDOUT_FILENO, &status) == 0 && status.st_dev == output.old->st_dev &&
         status.st_ino == output.old->st_ino;
}

/// True if the file lies among cases: a run that puts it there would read it as a case the next
/// time.
bool is_among_cases(const OutputTarget& output, const fs::path& input) {
  std::error_code error;
  if (output.path.extension() != ".json" || !fs::is_directory(input, error)) return false;
  const fs::path folder = output.path.parent_path();
  return fs::equivalent(folder.empty() ? "." : folder, input, error) && !error;
}

void check_input(const FilePlace& output, const OutputTarget& target, const FilePlace& input) {
  if (input.path.empty()) return;
  const std::string start = output.name + ": " + mesh_io::printable(output.path);
  std::error_code ignored;
  if (target.old && fs::equivalent(target.path, input.path, ignored)) {
    throw UsageError(start + " is " + input.name);
  }
  if (is_among_cases(target, input.path)) {
    throw UsageError(start + " lies among the cases of " + mesh_io::printable(input.path));
  }
}

}  // namespace

void check_outputs(std::span<const FilePlace> outputs, std::span<const FilePlace> inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const FilePlace& output = outputs[i];
    if (output.path.empty()) continue;
    const OutputTarget target = files::find_output_target(output.path);
    const std::string start = output.name + ": " + mesh_io::printable(output.path);
    for (const FilePlace& input : inputs)
      check_input(output, target, input);
    for (const FilePlace& other : outputs.subspan(i + 1)) {
      if (other.path.empty() || !is_same_file(target, other.path)) continue;
      throw UsageError(start + " is the file of " + other.name + ", too");
    }
    if (is_standard_output(target)) throw UsageError(start + " is where standard output goes");
    files::check_output(output.path);
  }
}

std::function<std::string(const std::string&)> file_name() {
  return [](const std::string& text) -> std::string {
    return text.empty() ? "\"\" is no name of a file" : "";
  };
}

}  // namespace graze::cli
