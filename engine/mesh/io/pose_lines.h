#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

#include <graze/engine/pose_text.h>

namespace graze::mesh_io {

/// Reads the poses of a text, one a line, one after the other, as load_pose_lines() does, without
/// holding them.
class PoseLines {
 public:
  /// Reads from `file`, whose next line has this number. Errors begin with `name`.
  PoseLines(std::istream& file, std::string name, std::size_t next_line = 1);

  /// Reads the next pose, behind blank lines. Returns false at the end. Throws PoseError as
  /// load_pose_lines() does.
  bool next(PoseLine& pose);

  /// Returns the number of the line that comes next.
  std::size_t next_line() const { return next_line_; }

 private:
  std::istream& file_;
  std::string name_;
  std::size_t next_line_;
  std::vector<char> buffer_;
};

}  // namespace graze::mesh_io
