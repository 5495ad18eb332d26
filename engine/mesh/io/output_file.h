#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace graze::mesh_io {

/// A file that is being written through a buffer. Unless finish() is reached, what has been written
/// is removed. Errors are MeshErrors that begin with the file's name.
class OutputFile {
 public:
  /// Creates the file or empties the one that is there.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void append(std::string_view bytes);

  /// Writes what is left and closes the file: a full disk may show only now.
  void finish();

 private:
  static constexpr std::size_t kCapacity = std::size_t{1} << 16;

  void flush();
  [[noreturn]] void fail_to_write(int error) const;

  std::filesystem::path path_;
  std::string name_;
  std::FILE* file_;
  std::size_t size_ = 0;
  std::unique_ptr<std::array<char, kCapacity>> buffer_;
};

}  // namespace graze::mesh_io
