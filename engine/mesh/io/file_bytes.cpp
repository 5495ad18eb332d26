#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace graze::mesh_io {
namespace {

constexpr std::size_t kFirstBytes = std::size_t{1} << 16;
constexpr std::size_t kMaxFirstBytes = std::size_t{1} << 30;

[[noreturn]] void fail_to_read(std::string_view name, int error) {
  fail({name, {}}, "cannot be read: " + std::generic_category().message(error));
}

/// Returns one byte more than the file is said to have, so that one read meets its end.
std::size_t first_size(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? kFirstBytes
               : static_cast<std::size_t>(std::min<std::uintmax_t>(size + 1, kMaxFirstBytes));
}

}  // namespace

void require_regular_file(const std::filesystem::path& path, std::string_view name) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  switch (status.type()) {
    case std::filesystem::file_type::regular:
      return;
    case std::filesystem::file_type::not_found:
      fail({name, {}}, "does not exist");
    case std::filesystem::file_type::directory:
      fail({name, {}}, "is a directory");
    case std::filesystem::file_type::none:
      fail_to_read(name, error.value());
    default:
      fail({name, {}}, "is not a regular file");
  }
}

std::string read_file(const std::filesystem::path& path, std::string_view name) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail_to_read(name, errno);
  std::string bytes(first_size(path), '\0');
  std::size_t size = 0;
  while (file.read(bytes.data() + size, static_cast<std::streamsize>(bytes.size() - size))) {
    size = bytes.size();
    bytes.resize(2 * size);
  }
  if (file.bad()) fail_to_read(name, errno);
  size += static_cast<std::size_t>(file.gcount());
  if (size == 0) fail({name, {}}, "is empty");
  bytes.resize(size);
  return bytes;
}

}  // namespace graze::mesh_io
