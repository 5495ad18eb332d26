#pragma once

#include <filesystem>
#include <string>

#include <graze/bvh/error.h>

namespace graze::files {

/// Thrown for a file that cannot be written: what() reads `file: cannot be written: why`.
class FileError : public Error {
 public:
  using Error::Error;
};

/// Throws FileError with the system's words for `error`, an errno.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

}  // namespace graze::files
