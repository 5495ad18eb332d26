#include <graze/engine/cli/view/view_run.h>

#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/recordings/recorded_gltf.h>
#include <graze/engine/cli/recordings/recording_file.h>
#include <graze/engine/cli/view/shown_pages.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/files/source.h>

#include <spawn.h>
#include <sys/wait.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>

extern char** environ;

namespace graze::cli {
namespace {

namespace fs = std::filesystem;

bool is_case(const std::string& file) {
  std::error_code ignored;
  const fs::path ending = fs::path(file).extension();
  return ending == ".json" || ending == ".jsonl" || fs::is_directory(file, ignored);
}

/// True if all are cases, false if none is; a mixture is refused.
bool are_cases(const ViewOptions& options) {
  const auto count = std::count_if(options.files.begin(), options.files.end(), is_case);
  if (count == 0) return false;
  if (count != std::ssize(options.files))
    throw UsageError("meshes and cases go to pages of their own");
  return true;
}

/// True if one is a recording; then all options must be about one.
bool has_recording(const ViewOptions& options) {
  const bool is_any = std::any_of(options.files.begin(), options.files.end(), is_recording);
  if (!is_any) {
    if (options.every != 1) throw UsageError("--every is about a recording: here is none");
    return false;
  }
  if (options.files.size() > 1) throw UsageError("a recording goes to a page of its own");
  if (options.poses || !options.pose_a.empty() || !options.pose_b.empty() ||
      !options.mesh_folder.empty())
    throw UsageError("--pose-a, --pose-b, --poses and --meshes are not about recordings");
  return true;
}

void check_options(const ViewOptions& options, bool has_cases) {
  if (options.poses && options.poses->empty())
    throw UsageError("--poses: the name of the file is empty");
  if (options.poses && !options.pose_b.empty())
    throw UsageError("--pose-b and --poses exclude each other: both place B");
  const bool has_poses = options.poses || !options.pose_a.empty() || !options.pose_b.empty();
  if (has_cases && has_poses)
    throw UsageError("--pose-a, --pose-b and --poses are about meshes: cases have their own poses");
  if (has_cases && options.tree) throw UsageError("--tree is about meshes: here are cases");
  if (!has_cases && !options.mesh_folder.empty())
    throw UsageError("--meshes is about cases: here are meshes");
  if (!has_cases && options.files.size() > 2) throw UsageError("more than two meshes");
  if (!has_cases && options.files.size() == 1 && (options.poses || !options.pose_b.empty()))
    throw UsageError("--pose-b and --poses need a second mesh");
}

void check_files(const ViewOptions& options) {
  std::vector<FilePlace> inputs;
  for (const std::string& file : options.files)
    inputs.push_back({"an input", file});
  if (options.poses) inputs.push_back({"the file of --poses", *options.poses});
  const std::array<FilePlace, 1> outputs = {{{"-o", options.page}}};
  check_outputs(outputs, inputs);
}

/// Opens the page by the program that opens files on this desktop. Throws UsageError, after the
/// page was written.
void open_page(const std::string& page) {
  std::string program = "xdg-open", file = fs::absolute(page).string();
  std::array<char*, 3> arguments = {program.data(), file.data(), nullptr};
  pid_t child = 0;
  int status = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0 ||
      waitpid(child, &status, 0) != child || status != 0)
    throw UsageError("--open: xdg-open has not opened " + mesh_io::printable(file));
}

void say(const ViewOptions& options, std::size_t pictures, std::size_t touching, std::size_t bytes,
         Output& output) {
  if (options.is_json)
    output.write(fmt::format("{{\"file\":{},\"pictures\":{},\"touching\":{},\"bytes\":{}}}\n",
                             cases::json_string(options.page), pictures, touching, bytes));
  else
    output.write(fmt::format(
        "{}: {} {}, {} touching, {:.1f} MB\n", mesh_io::printable(options.page), pictures,
        pictures == 1 ? "picture" : "pictures", touching, static_cast<double>(bytes) / 1e6));
}

/// Writes a recording for other programs, in place of a page.
ExitCode write_gltf(const ViewOptions& options, Output& output) {
  if (options.is_opened || !options.title.empty())
    throw UsageError("--open and --title are about pages, not about glTF");
  const RecordedGltf made = gltf_of_recording(options.files.front(), options.every);
  files::write_file(options.page, made.bytes);
  say(options, made.pictures, made.touching, made.bytes.size(), output);
  return ExitCode::Answered;
}

/// Shows the files. One file may be a scene; of several each must be a case.
ShownPage show(const ViewOptions& options, bool has_cases) {
  if (!has_cases) return show_meshes(options);
  const bool is_one = options.files.size() == 1 && is_scene(options.files.front());
  return is_one ? show_scene(options) : show_cases(options);
}

}  // namespace

ExitCode run_view(const ViewOptions& options, Output& output) {
  const bool is_of_recording = has_recording(options);
  const bool has_cases = !is_of_recording && are_cases(options);
  if (!is_of_recording) check_options(options, has_cases);
  check_files(options);
  if (is_of_recording && fs::path(options.page).extension() == ".glb")
    return write_gltf(options, output);
  const ShownPage shown = is_of_recording ? show_recording(options) : show(options, has_cases);
  const std::string page = shown.view.page();
  files::write_file(options.page, page);
  say(options, shown.frames, shown.touching, page.size(), output);
  if (options.is_opened) open_page(options.page);
  return shown.is_all_read ? ExitCode::Answered : ExitCode::BadInput;
}

}  // namespace graze::cli
