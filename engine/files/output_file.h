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

/// Writes a file through a buffer. A regular file appears whole, in one step, at publish() or
/// finish(); until then the file that was there before stays as it was, and if neither is reached,
/// it stays for good. Links are followed and stay; pipes, terminals and devices are written
/// through. All but append() within the buffer may throw FileError.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void append(std::string_view bytes);

  /// Hands the bytes that were appended to the system.
  void flush();

  /// Makes the appended bytes stand in the file, also after a crash. More can be appended, and
  /// stands in it with each flush().
  void publish();

  /// Publishes the file and closes it.
  void finish();

 private:
  static constexpr std::size_t kCapacity = std::size_t{1} << 16;

  [[noreturn]] void fail(int error) const;
  void sync() const;

  std::filesystem::path path_;  ///< the path as it was given, for messages
  OutputTarget target_;
  std::optional<TemporaryFile> temporary_;  ///< set until it has taken the place of the file
  int descriptor_ = -1;
  std::size_t size_ = 0;
  std::unique_ptr<std::array<char, kCapacity>> buffer_;
};

/// Writes a whole file at once. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace graze::files
