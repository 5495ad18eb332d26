#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/peers/process/child_process.h>
#include <graze/engine/files/source.h>

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace graze::compare {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostErrors = 4096;  // the bytes of standard error that are kept
constexpr std::size_t kLongestWords = 160;
constexpr std::chrono::milliseconds kPatience(1000);  // the time from the end of its output to its
                                                      // own end

/// Keeps SIGPIPE away from the thread while it lives, and takes away one that came of its writing:
/// a program that reads no more must not end this one.
class NoBrokenPipe {
 public:
  NoBrokenPipe() : signal_(), before_() {
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  ~NoBrokenPipe() {
    const timespec now = {};
    if (!was_pending_) {
      while (sigtimedwait(&signal_, nullptr, &now) == -1 && errno == EINTR) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoBrokenPipe(const NoBrokenPipe&) = delete;
  NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;

 private:
  sigset_t signal_;
  sigset_t before_;
  bool was_pending_ = false;
};

std::string name_of_signal(int number) {
  const char* name = sigabbrev_np(number);
  return name != nullptr ? std::string("SIG") + name : "signal " + std::to_string(number);
}

void set_nonblocking(int descriptor) {
  fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

/// Holds what posix_spawn() is told, until it has been.
class SpawnPlan {
 public:
  SpawnPlan() : actions_(), attributes_() {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    // Signals are as from a shell, whatever this process does with its own.
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigaddset(&signals, SIGPIPE);
    sigaddset(&signals, SIGINT);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  void connect(int descriptor, int as) {
    posix_spawn_file_actions_adddup2(&actions_, descriptor, as);
  }

  int run(pid_t& id, const std::vector<std::string>& command) {
    posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& argument : command)
      arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    return posix_spawn(&id, arguments.front(), &actions_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

void ChildProcess::Pipe::open() {
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  // The ends go above the three standard ones, should this process have closed its own: dup2() onto
  // itself would leave one open twice.
  for (int& end : ends) {
    if (end > STDERR_FILENO) continue;
    const int higher = fcntl(end, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (higher < 0) throw std::system_error(errno, std::generic_category(), "pipe");
    ::close(end);
    end = higher;
  }
}

void ChildProcess::Pipe::close() {
  close_end(0);
  close_end(1);
}

void ChildProcess::Pipe::close_end(int which) {
  if (ends[which] >= 0) ::close(ends[which]);
  ends[which] = -1;
}

ChildProcess::ChildProcess(const std::vector<std::string>& command) {
  for (Pipe* pipe : {&in_, &out_, &err_})
    pipe->open();
  SpawnPlan plan;
  plan.connect(in_.ends[0], STDIN_FILENO);
  plan.connect(out_.ends[1], STDOUT_FILENO);
  plan.connect(err_.ends[1], STDERR_FILENO);
  const int error = plan.run(id_, command);
  if (error != 0) {
    id_ = -1;
    throw EngineMissingError(mesh_io::printable(command.front()) + ": cannot be started: " +
                             std::strerror(error) + "; other engines run in this program");
  }
  in_.close_end(0);
  out_.close_end(1);
  err_.close_end(1);
  for (const int descriptor : {in_.ends[1], out_.ends[0], err_.ends[0]})
    set_nonblocking(descriptor);
}

// It is killed before it is waited for, so that its number still is its own.
ChildProcess::~ChildProcess() {
  if (id_ < 0) return;
  kill(-id_, SIGKILL);
  while (waitpid(id_, nullptr, 0) == -1 && errno == EINTR) {
  }
}

std::string ChildProcess::exchange(std::string_view text, Seconds timeout, std::size_t most) {
  const NoBrokenPipe no_signal;
  const auto start = Clock::now();
  std::size_t written = 0;
  std::size_t searched = 0;
  while (true) {
    const std::size_t end = written == text.size() ? unread_.find('\n', searched) : unread_.npos;
    if (end != unread_.npos) {
      std::string line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      return line;
    }
    searched = unread_.size();
    if (unread_.size() > most) {
      fail("wrote a line of more than " + std::to_string(most) + " bytes");
    }
    const Seconds left = timeout - Seconds(Clock::now() - start);
    if (left.count() <= 0) {
      std::array<char, 32> limit;
      std::snprintf(limit.data(), limit.size(), "%g", timeout.count());
      fail(std::string("gave no answer in ") + limit.data() + " s");
    }
    const bool is_writing = written < text.size();
    std::array<pollfd, 3> wait = {{{out_.ends[0], POLLIN, 0},
                                   {err_.ends[0], POLLIN, 0},
                                   {is_writing ? in_.ends[1] : -1, POLLOUT, 0}}};
    const double milliseconds = std::min(left.count() * 1000 + 1, 1e6);
    if (poll(wait.data(), wait.size(), static_cast<int>(milliseconds)) <= 0) continue;
    if (wait[1].revents != 0) read_errors();
    const bool is_heard = wait[2].revents == 0 || write_some(text, written);
    const bool is_open = wait[0].revents == 0 || read_some(out_.ends[0], unread_);
    if (!is_heard || !is_open) fail(end_of_it());
  }
}

/// Writes some of the text. False if nobody reads.
bool ChildProcess::write_some(std::string_view text, std::size_t& written) {
  const ssize_t count = write(in_.ends[1], text.data() + written, text.size() - written);
  if (count > 0) written += static_cast<std::size_t>(count);
  return count >= 0 || errno == EAGAIN || errno == EINTR;
}

/// Reads some bytes. False at the end.
bool ChildProcess::read_some(int descriptor, std::string& into) const {
  std::array<char, 65536> bytes;
  const ssize_t count = read(descriptor, bytes.data(), bytes.size());
  if (count > 0) into.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

void ChildProcess::read_errors() {
  if (err_.ends[0] < 0) return;
  if (!read_some(err_.ends[0], errors_)) err_.close_end(0);
  if (errors_.size() > kMostErrors) errors_.erase(0, errors_.size() - kMostErrors);
}

void ChildProcess::fail(const std::string& why) {
  throw EngineFailure(why + last_words());
}

/// Says how a program whose pipe is closed ended, or is made to.
std::string ChildProcess::end_of_it() {
  siginfo_t info = {};
  for (const auto start = Clock::now(); Clock::now() - start < kPatience;) {
    if (waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) break;
    if (info.si_pid == id_) break;
    poll(nullptr, 0, 1);
  }
  if (info.si_pid != id_) return "closed its pipe";
  if (info.si_code == CLD_EXITED) return "ended with exit code " + std::to_string(info.si_status);
  return "died of " + name_of_signal(info.si_status);
}

/// Returns the last line of its standard error, if it wrote any there.
std::string ChildProcess::last_words() {
  for (std::size_t before = errors_.size() + 1; err_.ends[0] >= 0 && before != errors_.size();) {
    before = errors_.size();
    read_errors();
  }
  std::string_view words = errors_;
  while (!words.empty() && (words.back() == '\n' || words.back() == ' '))
    words.remove_suffix(1);
  const std::size_t line = words.rfind('\n');
  if (line != words.npos) words.remove_prefix(line + 1);
  if (words.empty()) return "";
  return "; it said: " + mesh_io::printable(std::string(words.substr(0, kLongestWords)));
}

}  // namespace graze::compare
