#include <graze/engine/mesh/pairs/shared_walk.h>
#include <hwy/cache_control.h>

#include <thread>

namespace graze {

SharedWalk::Turn SharedWalk::begin() {
  ++walking_;
  return Turn(this);
}

void SharedWalk::give(bvh::WidePairWalk& walk) {
  const std::lock_guard lock(mutex_);
  walk.give_half(offer_);
  on_offer_ = offer_.size();
}

SharedWalk::Answer SharedWalk::try_take(bvh::WidePairWalk& walk) {
  const std::lock_guard lock(mutex_);
  if (offer_.empty()) return walking_ == 0 ? Answer::Never : Answer::Later;
  // A few pairs are walked at a time: should this thread have to make way for another program's,
  // the rest is there for others.
  for (std::size_t left = (offer_.size() + 3) / 4; left > 0; --left) {
    walk.start_at(offer_.back());
    offer_.pop_back();
  }
  on_offer_ = offer_.size();
  ++walking_;
  return Answer::Taken;
}

SharedWalk::Turn SharedWalk::take(bvh::WidePairWalk& walk) {
  constexpr int kSpins = 64;  // a microsecond or two: most offers come sooner
  ++waiting_;
  Answer answer = Answer::Later;
  for (int spins = 0; answer == Answer::Later; ++spins) {
    if (on_offer_ > 0 || walking_ == 0) {
      answer = try_take(walk);
    } else if (spins < kSpins) {
      hwy::Pause();
    } else {
      std::this_thread::yield();
    }
  }
  --waiting_;
  return Turn(answer == Answer::Taken ? this : nullptr);
}

}  // namespace graze
