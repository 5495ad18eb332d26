#include <graze/engine/cli/output/standard_streams.h>

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <initializer_list>

namespace graze::cli {

// In ascending order each gets its own number, the lowest that is free. Input is opened for
// writing, the others for reading, so that nobody takes them for streams that work.
void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

}  // namespace graze::cli
