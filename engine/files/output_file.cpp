#include <graze/engine/files/file_error.h>
#include <graze/engine/files/output_file.h>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace graze::files {
namespace {

/// True if syncing failed. Some file systems know no fsync(), and there that is no failure.
bool is_failure_to_sync(int error) {
  return error != EINVAL && error != ENOSYS && error != ENOTSUP && error != EROFS;
}

/// Syncs a folder, which holds the names of its files, as far as possible: some folders cannot be
/// opened.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor =
      open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

int open_through(const OutputTarget& target) {
  if (target.kind == OutputTarget::Kind::Descriptor) {
    return fcntl(target.descriptor, F_DUPFD_CLOEXEC, 0);
  }
  int descriptor = -1;
  do {
    descriptor = open(target.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path)
    : path_(path),
      target_(find_output_target(path)),
      buffer_(std::make_unique<std::array<char, kCapacity>>()) {
  if (target_.kind != OutputTarget::Kind::Replaced) {
    descriptor_ = open_through(target_);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  if (target_.old && access(target_.path.c_str(), W_OK) != 0) fail(errno);
  try {
    temporary_.emplace(target_.path, target_.old);
  } catch (const std::system_error& error) {
    fail(error.code().value());
  }
  descriptor_ = temporary_->take_descriptor();
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

void OutputFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    if (size_ == kCapacity) flush();
    const std::string_view part = bytes.substr(0, kCapacity - size_);
    std::memcpy(buffer_->data() + size_, part.data(), part.size());
    size_ += part.size();
    bytes.remove_prefix(part.size());
  }
}

void OutputFile::flush() {
  const std::size_t size = std::exchange(size_, 0);
  for (std::size_t done = 0; done < size;) {
    const ssize_t count = ::write(descriptor_, buffer_->data() + done, size - done);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {  // whoever opened it wants no waiting, but we do
      pollfd wait = {.fd = descriptor_, .events = POLLOUT, .revents = 0};
      poll(&wait, 1, -1);
    } else if (errno != EINTR) {
      fail(errno);
    }
  }
}

void OutputFile::sync() const {
  if (fsync(descriptor_) != 0 && is_failure_to_sync(errno)) fail(errno);
}

void OutputFile::publish() {
  flush();
  if (!temporary_) return;
  sync();
  const std::filesystem::path folder = target_.path.parent_path();  // afterwards nothing may throw
  try {
    temporary_->replace(target_.path);
  } catch (const std::system_error& error) {
    fail(error.code().value());
  }
  temporary_.reset();
  sync_folder(folder);
}

void OutputFile::finish() {
  publish();
  const int error = close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno;
  if (error != 0 && error != EINTR) fail(error);
}

void OutputFile::fail(int error) const {
  fail_to_write(path_, error);
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.append(bytes);
  file.finish();
}

}  // namespace graze::files
