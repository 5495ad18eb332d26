#include "tests/engine/cli/command.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace graze::tests {
namespace {

std::string read_all(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

CommandResult run(const std::filesystem::path& folder, const std::string& program,
                  const std::vector<std::string>& arguments,
                  const std::function<void(pid_t)>& meanwhile = {}) {
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  const std::filesystem::path out = folder / ".stdout";
  const std::filesystem::path err = folder / ".stderr";
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), kWrite, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), kWrite, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // They end it as they would from a terminal, also where whoever runs the tests ignores them.
  sigset_t interrupt;
  sigemptyset(&interrupt);
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT, SIGTERM})
    sigaddset(&interrupt, signal);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &interrupt);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int error =
      posix_spawn(&child, program.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot start " + program);

  if (meanwhile) meanwhile(child);
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_all(out), read_all(err)};
}

}  // namespace

CommandResult run_graze(const std::filesystem::path& folder,
                        const std::vector<std::string>& arguments) {
  return run(folder, GRAZE_COMMAND, arguments);
}

CommandResult interrupt_graze(const std::filesystem::path& folder,
                              const std::vector<std::string>& arguments,
                              const std::function<bool()>& is_time, int signal) {
  return run(folder, GRAZE_COMMAND, arguments, [&](pid_t child) {
    siginfo_t ended = {};
    while (!is_time()) {
      // An end is looked at without being taken, so that the id stays the command's own.
      waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
      if (ended.si_pid == child) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(child, signal);
  });
}

long peak_memory_of_graze(const std::filesystem::path& folder,
                          const std::vector<std::string>& arguments) {
  int ends[2] = {};
  if (pipe(ends) != 0) return -1;
  // A child of its own, whose children are no others.
  const pid_t child = fork();
  if (child == 0) {
    // The address sanitizer would keep what is freed, up to a quarter of a gigabyte.
    const char* options = getenv("ASAN_OPTIONS");
    const std::string without_keeping = std::string(options == nullptr ? "" : options) +
                                        ":quarantine_size_mb=0:thread_local_quarantine_size_kb=0";
    setenv("ASAN_OPTIONS", without_keeping.c_str(), 1);
    const CommandResult result = run_graze(folder, arguments);
    rusage usage = {};
    getrusage(RUSAGE_CHILDREN, &usage);
    const long peak = result.exit_code == 0 ? usage.ru_maxrss : -1;
    _exit(::write(ends[1], &peak, sizeof(peak)) == sizeof(peak) ? 0 : 1);
  }
  close(ends[1]);
  long peak = -1;
  if (::read(ends[0], &peak, sizeof(peak)) != sizeof(peak)) peak = -1;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return peak;
}

CommandResult run_shell(const std::filesystem::path& folder, const std::string& line) {
  setenv("GRAZE", GRAZE_COMMAND, 1);
  return run(folder, "/bin/sh", {"-c", line});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

}  // namespace graze::tests
