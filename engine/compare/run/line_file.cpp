#include <graze/engine/cases/case_error.h>
#include <graze/engine/compare/run/line_file.h>
#include <graze/engine/mesh/io/source.h>

#include <system_error>

namespace graze::compare {

LineFile::LineFile(const std::filesystem::path& path, std::span<const std::string> lines)
    : name_(mesh_io::printable(path.string())) {
  // Beside the old file, which is lost only when the new one is there.
  std::filesystem::path fresh = path;
  fresh += ".new";
  file_.open(fresh, std::ios::binary | std::ios::trunc);
  for (const std::string& line : lines)
    file_ << line << '\n';
  std::error_code error;
  if (file_.flush()) std::filesystem::rename(fresh, path, error);
  if (file_ && !error) return;
  std::error_code ignored;
  std::filesystem::remove(fresh, ignored);
  throw CaseError(name_ + ": cannot be written");
}

void LineFile::add(const std::string& line) {
  file_ << line << '\n';
  if (!file_.flush()) throw CaseError(name_ + ": cannot be written");
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
