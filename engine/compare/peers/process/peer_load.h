#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <graze/engine/compare/peers/process/peer_session.h>

namespace graze::compare {

/// The processes of one engine that nobody uses, and what it says of itself. Safe to use from many
/// threads.
class PeerPool {
 public:
  explicit PeerPool(PeerProgram program) : program_(std::move(program)) {}

  const PeerProgram& program() const { return program_; }

  /// One that is idle, whatever it has loaded, or a new one. Throws what PeerSession throws.
  std::unique_ptr<PeerSession> take();
  std::unique_ptr<PeerSession> start() const { return std::make_unique<PeerSession>(program_); }
  void give_back(std::unique_ptr<PeerSession> session);

  /// What the engine says of itself, asked once. Throws EngineMissingError; of an engine that fails
  /// before it says so nothing but its name is known.
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

/// What one engine has loaded, in as many processes as there are threads that ask at once. Safe to
/// use from many threads.
class PeerLoad {
 public:
  /// `member` is the load's text (protocol.h).
  PeerLoad(std::shared_ptr<PeerPool> pool, std::string member, PeerHistory history);
  ~PeerLoad();
  PeerLoad(const PeerLoad&) = delete;
  PeerLoad& operator=(const PeerLoad&) = delete;

  /// As PeerSession::request(); false also if the engine refuses what is to be loaded. That it
  /// fails to load is tried twice, and then remembered: each hanging load would cost the time limit
  /// again.
  bool request(std::string member, const std::function<void(const cases::JsonCursor&)>& on_reply);

 private:
  std::unique_ptr<PeerSession> take_loaded();
  std::unique_ptr<PeerSession> loaded(std::unique_ptr<PeerSession> session);

  std::shared_ptr<PeerPool> pool_;
  std::string member_;
  PeerHistory history_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PeerSession>> idle_;
  bool is_refused_ = false;
  std::optional<std::string> failure_;  ///< why nothing could be loaded
};

}  // namespace graze::compare
