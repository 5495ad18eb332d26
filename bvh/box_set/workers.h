#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <memory>

namespace graze::bvh {

/// The threads among which a box set shares its work, in chunks that do not depend on their number.
class Workers {
 public:
  explicit Workers(int threads) {
    if (threads > 1) arena_ = std::make_unique<tbb::task_arena>(threads);
  }

  /// False if the work had better be done in one go: one thread, or too little for more.
  bool share(std::size_t boxes) const { return arena_ != nullptr && boxes >= kFewBoxes; }

  template <typename Work>
  void for_each(std::size_t chunks, const Work& work) const {
    if (arena_ == nullptr || chunks < 2) {
      for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        work(chunk);
    } else {
      arena_->execute([&] { tbb::parallel_for(std::size_t{0}, chunks, work); });
    }
  }

  /// Runs work that starts tasks of its own.
  template <typename Work>
  void run(const Work& work) const {
    if (arena_ == nullptr) {
      tbb::task_arena(1).execute(work);
    } else {
      arena_->execute(work);
    }
  }

 private:
  static constexpr std::size_t kFewBoxes = 4096;

  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace graze::bvh
