#include <graze/engine/cli/output/output.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace graze::cli {

void Output::write(std::string_view text) {
  errno = 0;
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stream_) == text.size();
  if (is_written && std::fflush(stream_) == 0) return;
  if (errno == EPIPE) throw OutputClosed();
  throw OutputError(std::string("cannot write to standard output: ") + std::strerror(errno));
}

}  // namespace graze::cli
