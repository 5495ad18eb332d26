#include <graze/bvh/error.h>
#include <graze/engine/compare/run/line_file.h>
#include <graze/engine/files/file_error.h>
#include <graze/engine/files/source.h>

#include <fstream>

namespace graze::compare {

LineFile::LineFile(const std::filesystem::path& path, std::span<const std::string> lines) {
  try {
    file_ = std::make_unique<files::OutputFile>(path);
    for (const std::string& line : lines) {
      file_->append(line);
      file_->append("\n");
    }
    file_->publish();
  } catch (const files::FileError& error) {
    throw CaseError(error.what(), error.place());
  }
}

void LineFile::add(const std::string& line) {
  try {
    file_->append(line + '\n');
    file_->flush();
  } catch (const files::FileError& error) {
    throw CaseError(error.what(), error.place());
  }
}

void read_lines(const std::filesystem::path& path,
                const std::function<void(const cases::JsonCursor&, std::size_t)>& on_line) {
  const std::string name = mesh_io::printable(path.string());
  std::ifstream file(path, std::ios::binary);
  if (!file) throw CaseError(name + ": cannot be read");
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    if (file.eof()) break;  // no line break: the run was stopped while it wrote this
    const std::string place = name + ":" + std::to_string(number);
    const cases::JsonValue tree = cases::parse_json(line, place);
    on_line(cases::JsonCursor(tree, place), number);
  }
}

}  // namespace graze::compare
