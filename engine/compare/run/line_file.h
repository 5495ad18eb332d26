#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <span>
#include <string>

#include <graze/engine/cases/json_cursor.h>

namespace graze::compare {

/// A file that grows by a line at a time, each flushed, so that nothing is lost when a run is
/// stopped.
class LineFile {
 public:
  /// Puts these lines in the place of what was there. Throws CaseError.
  LineFile(const std::filesystem::path& path, std::span<const std::string> lines);
  void add(const std::string& line);

 private:
  std::string name_;
  std::ofstream file_;
};

/// Calls `on_line` with each line's JSON and its number, from 1. Throws CaseError, naming file and
/// line. A last line that a stopped run left unfinished is dropped.
void read_lines(const std::filesystem::path& path,
                const std::function<void(const cases::JsonCursor&, std::size_t)>& on_line);

}  // namespace graze::compare
