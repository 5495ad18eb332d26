#include <graze/engine/cli/output/output.h>

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <initializer_list>
#include <string>

namespace graze::cli {

void Output::write(std::string_view text) {
  errno = 0;
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stream_) == text.size();
  if (is_written && std::fflush(stream_) == 0) return;
  if (errno == EPIPE) throw OutputClosed();
  throw OutputError(std::string("cannot write to standard output: ") + std::strerror(errno));
}

// They go in ascending order, so that each gets its own number, the lowest that is free. Input is
// opened for writing, the others for reading, so that nobody takes them for streams that work.
void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

}  // namespace graze::cli
