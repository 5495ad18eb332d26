#pragma once

// This is private to engine/mesh.

#include <graze/bvh/wide/walk/wide_pair_walk.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace graze {

/// The place where the walkers of one pair of trees hand what waits in their walks to those who
/// have nothing left. How much work lies below a pair of boxes is known only when it has been
/// walked.
class SharedWalk {
 public:
  /// Ends a walker's turn, also where an exception does.
  struct EndTurn {
    void operator()(SharedWalk* shared) const { --shared->walking_; }
  };
  /// The turn of a walker who has something to walk, and may give of it: others wait for that.
  using Turn = std::unique_ptr<SharedWalk, EndTurn>;

  /// Begins the turn of whoever has the walk that all begins with.
  Turn begin();

  /// True if somebody waits and nothing is on offer.
  bool is_wanted() const { return waiting_ > 0 && on_offer_ == 0; }

  /// Offers half of what waits in a walk. Only a walker whose turn it is may call it.
  void give(bvh::WidePairWalk& walk);

  /// Waits until something is on offer, and moves a share of it into `walk`; null when all has been
  /// walked.
  Turn take(bvh::WidePairWalk& walk);

 private:
  enum class Answer { Taken, Later, Never };
  Answer try_take(bvh::WidePairWalk& walk);

  std::mutex mutex_;  ///< guards offer_; a walker who takes holds it until its turn is counted
  std::vector<bvh::WidePairWalk::Waiting> offer_;
  std::atomic<std::size_t> on_offer_{0};
  std::atomic<std::size_t> waiting_{0};
  std::atomic<std::size_t> walking_{0};
};

}  // namespace graze
