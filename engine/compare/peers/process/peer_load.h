#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <graze/engine/compare/peers/process/peer_session.h>

namespace graze::compare {

/// Keeps the processes of one engine that nobody uses, and what it says of itself. Many threads may
/// use it.
class PeerPool {
 public:
  explicit PeerPool(PeerProgram program) : program_(std::move(program)) {}

  const PeerProgram& program() const { return program_; }

  /// Returns a process that is idle, whatever it has loaded, or a new one. Throws what PeerSession
  /// throws.
  std::unique_ptr<PeerSession> take();
  std::unique_ptr<PeerSession> start() const { return std::make_unique<PeerSession>(program_); }
  void give_back(std::unique_ptr<PeerSession> session);

  /// Returns what the engine says of itself, asked once. Throws EngineMissingError; for an engine
  /// that fails before it says so nothing but its name is known.
  PeerHello hello();

 private:
  PeerProgram program_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PeerSession>> idle_;
  std::optional<PeerHello> hello_;
};

enum class PeerHistory {
  Shared,  ///< in processes that were asked other questions before, about this and about others
  None,    ///< in processes that have loaded nothing else, as if nothing had been asked before
};

/// Holds what one engine has loaded, in one process and, if that is not enough, in more, one for
/// each thread that asks at once. A thread that finds all of them busy waits: only when threads
/// have waited together for as long as two loads take, another process is loaded. So quick
/// questions need one process, slow ones soon as many as there are threads, and waiting costs no
/// run more than two loads for each process. Many threads may use it.
class PeerLoad {
 public:
  /// Takes the load's text `member` (protocol.h).
  PeerLoad(std::shared_ptr<PeerPool> pool, std::string member, PeerHistory history);
  ~PeerLoad();
  PeerLoad(const PeerLoad&) = delete;
  PeerLoad& operator=(const PeerLoad&) = delete;

  /// Does what PeerSession::request() does; false also if the engine refuses what is to be loaded.
  /// If loading fails it is tried a second time, and then the failure is told without trying until
  /// ten times as long has passed: what failed for want of memory may go well later, and what hangs
  /// takes a tenth of the time.
  bool request(std::string member, const std::function<void(const cases::JsonCursor&)>& on_reply);

 private:
  using Clock = std::chrono::steady_clock;

  std::unique_ptr<PeerSession> take_loaded();
  void wait_for_one(std::unique_lock<std::mutex>& lock);
  std::unique_ptr<PeerSession> load_one();
  std::unique_ptr<PeerSession> loaded(std::unique_ptr<PeerSession> session);

  std::shared_ptr<PeerPool> pool_;
  std::string member_;
  PeerHistory history_;
  std::mutex mutex_;
  std::condition_variable has_changed_;
  std::vector<std::unique_ptr<PeerSession>> idle_;
  std::size_t busy_ = 0;     ///< the sessions that threads have, and will bring back or lose
  bool is_loading_ = false;  ///< true while one more is being loaded
  Clock::duration load_time_{0};
  Clock::duration waited_{0};  ///< the time that all threads together have waited since the last
                               ///< load
  bool is_refused_ = false;
  std::optional<std::string> failure_;  ///< why nothing could be loaded
  Clock::time_point next_try_;          ///< the time when that is tried again
};

}  // namespace graze::compare
