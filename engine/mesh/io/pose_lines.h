#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

#include <graze/engine/pose_text.h>

namespace graze::mesh_io {

/// Poses of a text, one a line, one after the other: what load_pose_lines() reads, without holding
/// it.
class PoseLines {
 public:
  /// The next line of `file` is that of this number. Errors begin with `name`.
  PoseLines(std::istream& file, std::string name, std::size_t next_line = 1);

  /// The next pose, behind blank lines; false at the end. Throws PoseError as load_pose_lines()
  /// does.
  bool next(PoseLine& pose);

  /// The number of the line that comes next.
  std::size_t next_line() const { return next_line_; }

 private:
  std::istream& file_;
  std::string name_;
  std::size_t next_line_;
  std::vector<char> buffer_;
};

}  // namespace graze::mesh_io
