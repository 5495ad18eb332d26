#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

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
      const fs::path ending = entry.path().extension();
      if (ending == ".json" || ending == ".jsonl") found.push_back(entry.path());
    }
    if (found.empty()) {
      throw CaseError(mesh_io::printable(argument) +
                      ": holds no case, no file that ends in .json or .jsonl");
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

void read_listed_cases(const fs::path& file, const ReadCaseSettings& settings,
                       const std::function<void(ListedCase)>& on_case,
                       const std::function<void(const Error&)>& on_refusal) {
  const auto add = [&](const std::string& name, const fs::path& alone, const auto& read) {
    try {
      on_case({name, alone, read()});
    } catch (const Error& error) {
      on_refusal(error);
    }
  };
  if (file.extension() != ".jsonl") {
    add(file.string(), file, [&] { return read_case(file, settings); });
    return;
  }
  std::error_code ignored;
  std::ifstream lines(file, std::ios::binary);
  const std::string name = mesh_io::printable(file.string());
  if (!lines || fs::is_directory(file, ignored) ||
      lines.peek() == std::ifstream::traits_type::eof()) {
    on_refusal(CaseError(name + ": cannot be read, or is empty"));
    return;
  }
  ReadCaseSettings here = settings;
  if (here.mesh_folder.empty()) here.mesh_folder = file.parent_path();
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string place = file.string() + ":" + std::to_string(++number);
    add(place, {}, [&] { return parse_case(line, mesh_io::printable(place), here); });
  }
}

}  // namespace graze::cli
