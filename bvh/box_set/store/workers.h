#pragma once

#include <graze/bvh/box_set/store/fork.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace graze::bvh {

/// The threads among which a box set shares its work, in chunks that do not depend on their number.
class Workers {
 public:
  explicit Workers(int threads) {
    if (threads > 1) arena_ = std::make_unique<tbb::task_arena>(std::min(threads, kMostThreads));
  }

  /// False if the work had better be done in one go: one thread, or too little for more.
  bool share(std::size_t boxes) const { return arena_ != nullptr && boxes >= kFewBoxes; }

  template <typename Work>
  void for_each(std::size_t chunks, const Work& work) const {
    if (arena_ == nullptr || chunks < 2) {
      for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        work(chunk);
    } else {
      arena_->execute([&] { fork_each(chunks, work); });
    }
  }

  /// Runs work that forks.
  template <typename Work>
  void run(const Work& work) const {
    // An arena may hand the work to another thread.
    const auto computed = [&work] { in_standard_arithmetic([&] { work(); }); };
    if (arena_ == nullptr) {
      tbb::task_arena(1).execute(computed);
    } else {
      arena_->execute(computed);
    }
  }

 private:
  static constexpr std::size_t kFewBoxes = 4096;
  static constexpr int kMostThreads =
      256;  ///< oneTBB crashes where it has no memory for as many as asked

  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace graze::bvh
