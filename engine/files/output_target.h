#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>

namespace graze::files {

/// Says where the bytes go that are written to a path.
struct OutputTarget {
  enum class Kind {
    Replaced,    ///< a regular file, or none yet: another one takes its place
    Through,     ///< a pipe, a terminal, a device: opened and written to
    Descriptor,  ///< a descriptor that this process has open already: /dev/stdout, /proc/self/fd/3
  };

  Kind kind = Kind::Replaced;
  std::filesystem::path path;           ///< the path with its last links followed
  std::optional<struct stat> old = {};  ///< the file that is there, for Replaced
  int descriptor = -1;                  ///< the descriptor, for Descriptor
};

/// Finds the target of a path. It follows links, also one to a file that is not there. Throws
/// FileError, naming `path`, for a folder, for links in a circle, and for a path that cannot be
/// followed.
OutputTarget find_output_target(const std::filesystem::path& path);

/// Throws FileError if it can be seen beforehand that the path cannot be written, before any work
/// is done in vain. It opens and creates nothing.
void check_output(const std::filesystem::path& path);

}  // namespace graze::files
