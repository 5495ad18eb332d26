#include <graze/engine/files/file_error.h>
#include <graze/engine/files/output_target.h>
#include <graze/engine/files/source.h>

#include <linux/magic.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <string>
#include <system_error>

namespace graze::files {
namespace {

namespace fs = std::filesystem;

/// Linux follows as many links.
constexpr int kMostLinks = 40;

fs::path folder_of(const fs::path& path) {
  const fs::path folder = path.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

/// True for a folder of processes: what a link there says is for people, and opening it leads to
/// what a process has open.
bool is_of_processes(const fs::path& folder) {
  struct statfs system = {};
  return statfs(folder.c_str(), &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
}

/// Returns the number of the descriptor of this process that the path names; -1 if it names none.
int own_descriptor(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::canonical(folder_of(path), error);
  if (error) return -1;
  const bool is_own = folder == fs::canonical("/proc/self/fd", error) ||
                      folder == fs::canonical("/proc/thread-self/fd", error);
  if (!is_own) return -1;
  const std::string name = path.filename().string();
  int number = -1;
  const auto end = std::from_chars(name.data(), name.data() + name.size(), number);
  return end.ec == std::errc() && end.ptr == name.data() + name.size() ? number : -1;
}

/// True if the file is another user's in a folder such as /tmp, where it may be written, but not
/// replaced.
bool is_another_users(const struct stat& file, const struct stat& folder) {
  const uid_t user = geteuid();
  return (folder.st_mode & S_ISVTX) != 0 && user != 0 && user != file.st_uid &&
         user != folder.st_uid;
}

OutputTarget target_of_process(const fs::path& given, const fs::path& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) fail_to_write(given, errno);
  if (S_ISDIR(status.st_mode)) fail_to_write(given, EISDIR);
  const int descriptor = own_descriptor(path);
  const auto kind = descriptor < 0 ? OutputTarget::Kind::Through : OutputTarget::Kind::Descriptor;
  return {.kind = kind, .path = path, .old = std::nullopt, .descriptor = descriptor};
}

}  // namespace

void fail_to_write(const fs::path& path, int error) {
  throw FileError(mesh_io::printable(path.string()) +
                      ": cannot be written: " + std::generic_category().message(error),
                  {.file = path.string()});
}

OutputTarget find_output_target(const fs::path& given) {
  if (given.empty()) fail_to_write(given, ENOENT);
  fs::path path = given;
  for (int links = 0; links <= kMostLinks; ++links) {
    struct stat status = {};
    if (lstat(path.c_str(), &status) != 0) {
      if (errno != ENOENT) fail_to_write(given, errno);
      if (!path.has_filename()) fail_to_write(given, EISDIR);
      return {.kind = OutputTarget::Kind::Replaced, .path = path};
    }
    if (S_ISDIR(status.st_mode)) fail_to_write(given, EISDIR);
    if (S_ISREG(status.st_mode)) {
      return {.kind = OutputTarget::Kind::Replaced, .path = path, .old = status};
    }
    if (S_ISSOCK(status.st_mode)) fail_to_write(given, ENXIO);  // open() would fail likewise
    if (!S_ISLNK(status.st_mode)) return {.kind = OutputTarget::Kind::Through, .path = path};
    const fs::path folder = folder_of(path);
    if (is_of_processes(folder)) return target_of_process(given, path);
    std::error_code error;
    const fs::path next = fs::read_symlink(path, error);
    if (error) fail_to_write(given, error.value());
    path = next.is_absolute() ? next : folder / next;
  }
  fail_to_write(given, ELOOP);
}

void check_output(const fs::path& given) {
  const OutputTarget target = find_output_target(given);
  if (target.kind == OutputTarget::Kind::Descriptor) return;
  const bool is_there = target.kind == OutputTarget::Kind::Through || target.old;
  if (is_there && access(target.path.c_str(), W_OK) != 0) fail_to_write(given, errno);
  if (target.kind == OutputTarget::Kind::Through) return;
  const fs::path folder = folder_of(target.path);
  struct stat status = {};
  if (stat(folder.c_str(), &status) != 0) fail_to_write(given, errno);
  if (!S_ISDIR(status.st_mode)) fail_to_write(given, ENOTDIR);
  if (access(folder.c_str(), W_OK | X_OK) != 0) fail_to_write(given, errno);
  if (target.old && is_another_users(*target.old, status)) fail_to_write(given, EPERM);
}

}  // namespace graze::files
