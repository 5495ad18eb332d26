#include <graze/engine/compare/peers/process/peer_load.h>

#include <utility>

namespace graze::compare {

std::unique_ptr<PeerSession> PeerPool::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<PeerSession> session = std::move(idle_.back());
      idle_.pop_back();
      return session;
    }
  }
  return start();
}

void PeerPool::give_back(std::unique_ptr<PeerSession> session) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(session));
}

PeerHello PeerPool::hello() {
  const std::lock_guard lock(mutex_);
  if (hello_) return *hello_;
  PeerHello hello{.witness = {program_.name, ""}};
  try {
    idle_.push_back(start());
    hello = idle_.back()->hello();
  } catch (const EngineFailure&) {  // told again when it is asked
  }
  hello_ = hello;
  return hello;
}

PeerLoad::PeerLoad(std::shared_ptr<PeerPool> pool, std::string member, PeerHistory history)
    : pool_(std::move(pool)), member_(std::move(member)), history_(history) {}

PeerLoad::~PeerLoad() {
  if (history_ == PeerHistory::None) return;
  for (std::unique_ptr<PeerSession>& session : idle_)
    pool_->give_back(std::move(session));
}

bool PeerLoad::request(std::string member,
                       const std::function<void(const cases::JsonCursor&)>& on_reply) {
  std::unique_ptr<PeerSession> session = take_loaded();
  if (!session) return false;
  const bool is_alone = history_ == PeerHistory::None;
  const bool can_fork = session->hello().can_fork;
  if (is_alone && can_fork) member += ",\"alone\":true";
  const bool is_answered = session->request(member, on_reply);
  if (is_alone && !can_fork) return is_answered;  // its history has begun
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(session));
  return is_answered;
}

/// Null if the engine refuses.
std::unique_ptr<PeerSession> PeerLoad::take_loaded() {
  {
    const std::lock_guard lock(mutex_);
    if (is_refused_) return nullptr;
    if (failure_) throw EngineFailure(*failure_);
    if (!idle_.empty()) {
      std::unique_ptr<PeerSession> session = std::move(idle_.back());
      idle_.pop_back();
      return session;
    }
  }
  if (history_ == PeerHistory::Shared) {
    try {
      return loaded(pool_->take());
    } catch (const EngineFailure&) {  // perhaps of what was there before
    }
  }
  try {
    return loaded(pool_->start());
  } catch (const EngineFailure& failure) {
    const std::lock_guard lock(mutex_);
    failure_ = failure.what();
    throw;
  }
}

std::unique_ptr<PeerSession> PeerLoad::loaded(std::unique_ptr<PeerSession> session) {
  const bool is_loaded = session->request(member_, [](const cases::JsonCursor& at) {
    if (!at.member("loaded").boolean()) at.member("loaded").fail("is false");
  });
  if (is_loaded) return session;
  if (history_ == PeerHistory::Shared) pool_->give_back(std::move(session));
  const std::lock_guard lock(mutex_);
  is_refused_ = true;
  return nullptr;
}

}  // namespace graze::compare
