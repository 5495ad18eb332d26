#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace graze::tests {

/// A folder of its own for one test, removed at its end: tests run at the same time.
class TemporaryDirectory {
 public:
  /// Throws std::runtime_error if the folder cannot be made.
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// The path of a file in it, whether or not there is one.
  std::string path(std::string_view name) const { return (path_ / name).string(); }

  /// Writes a file and returns its path. Throws std::runtime_error if it cannot.
  std::string write(std::string_view name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

}  // namespace graze::tests
