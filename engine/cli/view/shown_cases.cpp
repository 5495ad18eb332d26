#include <graze/engine/cli/view/shown_pages.h>

#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/view/case_pictures.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;

std::string title_of(const ViewOptions& options) {
  if (!options.title.empty()) return options.title;
  if (options.files.size() > 1) return std::to_string(options.files.size()) + " files of cases";
  const fs::path path = fs::path(options.files.front()).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace

ShownPage show_cases(const ViewOptions& options) {
  CaseMeshes meshes;
  std::vector<ListedCase> cases;
  std::vector<std::string> refusals;
  for (const fs::path& file : case_files(options.files))
    read_listed_cases(
        file, {.mesh_folder = options.mesh_folder, .meshes = &meshes},
        [&](ListedCase each) { cases.push_back(std::move(each)); },
        [&](const Error& error) { refusals.emplace_back(error.what()); });
  if (cases.empty() && refusals.size() == 1) throw CaseError(refusals.front());
  for (const std::string& refusal : refusals)
    std::fprintf(stderr, "graze: %s\n", mesh_io::printable(refusal).c_str());
  if (cases.empty()) throw CaseError("no case can be read");
  ViewSettings settings = {.title = title_of(options)};
  if (std::any_of(cases.begin(), cases.end(),
                  [](const ListedCase& each) { return has_course(each.query); }))
    settings.notes.emplace_back("Motions are shown at " + std::to_string(kMotionPictures) +
                                " times. What is between two of them is not seen here.");
  for (const std::string& refusal : refusals)
    settings.notes.push_back("Left out: " + refusal);
  ShownPage page(settings);
  page.is_all_read = refusals.empty();
  Progress progress("cases:", cases.size(), {.is_forced = options.has_progress, .has_rows = false});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    show_case(cases[i], page);
    progress.update(i + 1);
  }
  return page;
}

}  // namespace graze::cli
