// Runs `graze-peer ENGINE`: one of the engines of the adaptors, asked over its standard input.
// README.md has the protocol.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/process/serve_engine.h>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>
#include <thread>

namespace {

/// A question may go on for so long when whoever asked it is gone.
constexpr std::chrono::seconds kGrace(10);

/// Ends a process that hangs when the one that would have ended it is gone.
void end_when_nobody_asks() {
  pollfd wait = {STDIN_FILENO, 0, 0};  // the hang-up is told unasked
  while (poll(&wait, 1, -1) <= 0 && errno == EINTR) {
  }
  std::this_thread::sleep_for(kGrace);
  _exit(1);
}

int refuse(const std::string& why) {
  std::fprintf(stderr, "graze-peer: %s\n", why.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc == 2 ? argv[1] : "";
  const std::unique_ptr<graze::compare::Engine> engine = graze::compare::make_adaptor(name);
  if (!engine)
    return refuse("usage: graze-peer ENGINE, which is one of " + graze::compare::adaptor_names());
  // What a library prints must not come between the lines of the protocol.
  const int replies = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (replies < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return refuse(std::strerror(errno));
  std::thread(end_when_nobody_asks).detach();
  try {
    // It runs in standard arithmetic however libraries that were loaded have set it: an engine is
    // asked as it is in any program.
    graze::bvh::in_standard_arithmetic(
        [&] { graze::compare::serve_engine(*engine, std::cin, replies); });
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
  std::fflush(stdout);
  _exit(0);  // it ends without the destructors that the other thread might still meet
}
