#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace graze::compare {

/// Runs another program that is asked by lines on its standard input and answers by lines on its
/// standard output. One thread at a time may use it. Its standard error is read too, so that it
/// never blocks there, and the last line of it is told if the program fails. The program leads a
/// process group of its own: ^C at a terminal does not reach it, and all that it starts ends with
/// it.
class ChildProcess {
 public:
  using Seconds = std::chrono::duration<double>;

  /// Starts the program, with its arguments behind it. Throws EngineMissingError, which names it.
  explicit ChildProcess(const std::vector<std::string>& command);

  /// Ends the program at once.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes `text`, which ends in a line break or is empty, and returns the next line that the
  /// program writes, without its break. Throws EngineFailure if that does not come: what became of
  /// the program ("died of SIGSEGV", "ended with exit code 3"), that it took longer than `timeout`,
  /// or that its line is longer than `most` bytes. Nothing can be asked of it afterwards.
  std::string exchange(std::string_view text, Seconds timeout, std::size_t most);

  pid_t id() const { return id_; }

 private:
  class Pipe {
   public:
    Pipe() = default;
    ~Pipe() { close(); }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void open();
    void close();
    void close_end(int which);
    int ends[2] = {-1, -1};  ///< the end to read from, the end to write to
  };

  bool write_some(std::string_view text, std::size_t& written);
  bool read_some(int descriptor, std::string& into) const;
  void read_errors();
  [[noreturn]] void fail(const std::string& why);
  std::string end_of_it();
  std::string last_words();

  Pipe in_, out_, err_;
  pid_t id_ = -1;
  std::string unread_;  ///< text that the program wrote and nobody has read yet
  std::string errors_;  ///< the end of what it wrote to its standard error
};

}  // namespace graze::compare
