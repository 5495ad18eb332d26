#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/peers/process/child_process.h>
#include <graze/engine/compare/peers/process/protocol.h>

namespace graze::compare {

/// Names an engine that speaks the protocol.
struct PeerProgram {
  std::string name;  ///< the engine's name, which it must give itself; empty for any name
  std::vector<std::string> command;  ///< the program and its arguments
  ChildProcess::Seconds timeout{60};
  std::size_t longest_line = std::size_t{256} << 20;  ///< bytes
};

/// This is one process of an engine. One thread may use it at a time. What the engine does other
/// than answering, or refusing, is thrown as EngineFailure; then the session is of no use any more.
class PeerSession {
 public:
  /// Starts the process and hears who it is. Throws EngineMissingError, EngineFailure.
  explicit PeerSession(const PeerProgram& program);

  const PeerHello& hello() const { return hello_; }
  pid_t process_id() const { return process_.id(); }

  /// Sends a request with such a member (protocol.h) and calls `on_reply` with the reply, unless
  /// that is a refusal: then it returns false. Whatever `on_reply` cannot read makes a failure.
  bool request(std::string_view member,
               const std::function<void(const cases::JsonCursor&)>& on_reply);

 private:
  std::string next_line(std::string_view request);

  const PeerProgram& program_;
  ChildProcess process_;
  PeerHello hello_;
  std::uint64_t last_id_ = 0;
};

}  // namespace graze::compare
