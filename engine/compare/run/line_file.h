#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/files/output_file.h>

namespace graze::compare {

/// A file that grows by a line at a time, each handed to the system, so that nothing is lost when a
/// run is stopped. A pipe or a device is written through.
class LineFile {
 public:
  /// Puts these lines in the place of what was there, in one step. Throws CaseError.
  LineFile(const std::filesystem::path& path, std::span<const std::string> lines);
  void add(const std::string& line);

 private:
  std::unique_ptr<files::OutputFile> file_;
};

/// Calls `on_line` with each line's JSON and its number, from 1. Throws CaseError, naming file and
/// line. A last line that a stopped run left unfinished is dropped.
void read_lines(const std::filesystem::path& path,
                const std::function<void(const cases::JsonCursor&, std::size_t)>& on_line);

}  // namespace graze::compare
