#include <graze/engine/mesh/io/output_file.h>
#include <graze/engine/mesh/io/source.h>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace graze::mesh_io {
namespace {

/// Only what is a file is removed, not a device or a pipe; and what a link leads to, not the link.
void remove_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  if (error || !std::filesystem::is_regular_file(real, error)) return;
  std::filesystem::remove(real, error);
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path)
    : path_(path),
      name_(printable(path.string())),
      file_(nullptr),
      buffer_(std::make_unique<std::array<char, kCapacity>>()) {
  errno = 0;
  file_ = std::fopen(path.c_str(), "wb");
  if (file_ == nullptr) fail_to_write(errno);
  std::setvbuf(file_, nullptr, _IONBF, 0);  // the buffer is here
}

OutputFile::~OutputFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  remove_file(path_);
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
  errno = 0;
  if (std::fwrite(buffer_->data(), 1, size_, file_) != size_) fail_to_write(errno);
  size_ = 0;
}

void OutputFile::finish() {
  flush();
  errno = 0;
  std::FILE* const file = file_;
  file_ = nullptr;
  if (std::fclose(file) == 0) return;
  const int error = errno;
  remove_file(path_);
  fail_to_write(error);
}

void OutputFile::fail_to_write(int error) const {
  fail({name_, {}}, "cannot be written: " + std::generic_category().message(error));
}

}  // namespace graze::mesh_io
