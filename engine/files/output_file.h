#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include <graze/engine/files/output_target.h>
#include <graze/engine/files/temporary_file.h>

namespace graze::files {

/// A file that is being written through a buffer. A regular file appears whole, in one step, at
/// publish() or finish(); until then what was there before is as it was, and if neither is reached,
/// it stays so. Links are followed and stay; pipes, terminals and devices are written through. All
/// but append() within the buffer may throw FileError.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void append(std::string_view bytes);

  /// Hands what was appended to the system.
  void flush();

  /// What was appended stands in the file, also after a crash; more can be appended, and stands in
  /// it with each flush().
  void publish();

  /// The same, and closes the file.
  void finish();

 private:
  static constexpr std::size_t kCapacity = std::size_t{1} << 16;

  [[noreturn]] void fail(int error) const;
  void sync() const;

  std::filesystem::path path_;  ///< as it was given, for messages
  OutputTarget target_;
  std::optional<TemporaryFile> temporary_;  ///< until it has taken the place of the file
  int descriptor_ = -1;
  std::size_t size_ = 0;
  std::unique_ptr<std::array<char, kCapacity>> buffer_;
};

/// Writes a whole file at once. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace graze::files
