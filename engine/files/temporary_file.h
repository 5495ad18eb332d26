#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>

namespace graze::files {

/// A new file beside another one, whose place it takes; unless it does, it is removed.
class TemporaryFile {
 public:
  /// Creates the file in the folder of `target`. Whoever may open `old`, if there is that, may open
  /// it. Throws std::system_error.
  TemporaryFile(const std::filesystem::path& target, const std::optional<struct stat>& old);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Returns the descriptor, open for writing; whoever takes it closes it.
  int take_descriptor();

  /// Puts the file in the place of `target`, in one step. Throws std::system_error.
  void replace(const std::filesystem::path& target);

 private:
  void remove();

  std::filesystem::path path_;
  int descriptor_ = -1;
  int slot_ = -1;  ///< the place in the list of files that a signal handler removes; -1 if the list
                   ///< was full
  bool is_there_ = false;
};

/// Removes all temporary files of this process. Signal handlers may call it: it calls unlink() and
/// getpid(), and takes no lock. In a process that was forked it does nothing, for they are its
/// parent's.
void remove_temporary_files() noexcept;

}  // namespace graze::files
