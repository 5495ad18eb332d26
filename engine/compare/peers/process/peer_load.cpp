#include <graze/engine/compare/peers/process/peer_load.h>

#include <utility>

namespace graze::compare {
namespace {

/// After a load that failed nobody tries again for so many times as long as it took.
constexpr int kTimesAsLong = 10;

/// Another process is loaded once threads have waited, all together, for as long as so many loads
/// take. With fewer, short runs would begin a process of which they have no more use.
constexpr int kLoadsToWait = 2;

}  // namespace

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
  } catch (const EngineFailure&) {  // it is told again when it is asked
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
  // The session comes back, unless it has failed, or its history has begun.
  const auto give_back = [&](std::unique_ptr<PeerSession> used) {
    const std::lock_guard lock(mutex_);
    --busy_;
    if (!used) return has_changed_.notify_all();
    idle_.push_back(std::move(used));
    has_changed_.notify_one();
  };
  try {
    const bool is_answered = session->request(member, on_reply);
    give_back(is_alone && !can_fork ? nullptr : std::move(session));
    return is_answered;
  } catch (...) {
    give_back(nullptr);
    throw;
  }
}

/// Returns a session that has loaded it; null if the engine refuses.
std::unique_ptr<PeerSession> PeerLoad::take_loaded() {
  {
    std::unique_lock lock(mutex_);
    if (failure_ && Clock::now() >= next_try_) failure_.reset();
    wait_for_one(lock);
    if (is_refused_) return nullptr;
    if (!idle_.empty()) {
      std::unique_ptr<PeerSession> session = std::move(idle_.back());
      idle_.pop_back();
      ++busy_;
      return session;
    }
    if (failure_) throw EngineFailure(*failure_);
    ++busy_;
    is_loading_ = true;
  }
  const auto start = Clock::now();
  const auto ended = [&](std::size_t gone) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (failure_) next_try_ = now + kTimesAsLong * (now - start);
    is_loading_ = false;
    busy_ -= gone;
    has_changed_.notify_all();
  };
  try {
    std::unique_ptr<PeerSession> session = load_one();
    {
      const std::lock_guard lock(mutex_);
      load_time_ = Clock::now() - start;
      waited_ = Clock::duration(0);
    }
    ended(session ? 0 : 1);
    return session;
  } catch (...) {
    ended(1);
    throw;
  }
}

/// Waits until a session is idle, or known not to come, or until it is time to load another, which
/// is never if that has failed. None comes back from an engine whose every question takes a process
/// of its own.
void PeerLoad::wait_for_one(std::unique_lock<std::mutex>& lock) {
  if (history_ == PeerHistory::None && !pool_->hello().can_fork) return;
  while (idle_.empty() && !is_refused_) {
    if (!is_loading_ && busy_ == 0) return;
    if (is_loading_ || failure_) {
      has_changed_.wait(lock);
      continue;
    }
    if (waited_ >= kLoadsToWait * load_time_) return;
    const auto start = Clock::now();
    has_changed_.wait_for(lock, kLoadsToWait * load_time_ - waited_);
    waited_ += Clock::now() - start;
  }
}

std::unique_ptr<PeerSession> PeerLoad::load_one() {
  if (history_ == PeerHistory::Shared) {
    try {
      return loaded(pool_->take());
    } catch (const EngineFailure&) {  // perhaps it failed because of what was there before
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
