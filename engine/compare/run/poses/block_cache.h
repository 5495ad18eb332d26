#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace graze::compare {

/// Holds a long list that is made block by block where it is needed, and keeps the blocks that were
/// needed last. Many threads may read it. A thread that needs a block that another one is making
/// waits for it, and meanwhile makes one of the next ones if there are any, so that a long list
/// that is slow to make is made by all threads that read it.
template <typename Item>
class BlockCache {
 public:
  using Block = std::shared_ptr<const std::vector<Item>>;

  /// Makes up to `count` blocks ahead; with 0 none is.
  explicit BlockCache(std::function<std::vector<Item>(std::size_t block)> make,
                      std::size_t count = 0)
      : make_(std::move(make)), count_(count) {}

  /// Returns a block. Throws what making it throws.
  Block at(std::size_t block) const {
    Begun begun = begin(block);
    if (begun.promise) {
      make(block, *begun.promise);
    } else if (begun.future.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      make_ahead(block);
    }
    return begun.future.get();
  }

 private:
  struct Begun {
    std::shared_future<Block> future;
    std::optional<std::promise<Block>> promise = {};  ///< set if the caller is to make it
  };

  /// Finds a block, or begins it.
  Begun begin(std::size_t block) const {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const auto& each) { return each.first == block; });
    if (found != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, found);
      return {kept_.front().second};
    }
    std::promise<Block> promise;
    kept_.emplace_front(block, promise.get_future().share());
    if (kept_.size() > kMostKept) kept_.pop_back();
    return {kept_.front().second, std::move(promise)};
  }

  void make(std::size_t block, std::promise<Block>& promise) const {
    try {
      promise.set_value(std::make_shared<const std::vector<Item>>(make_(block)));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  }

  /// Makes the first of the next blocks that nobody has begun.
  void make_ahead(std::size_t block) const {
    const std::size_t end = std::min(count_, block + 1 + kMostAhead);
    for (std::size_t next = block + 1; next < end; ++next) {
      Begun begun = begin(next);
      if (!begun.promise) continue;
      make(next, *begun.promise);
      return;
    }
  }

  static constexpr std::size_t kMostKept = 16;
  static constexpr std::size_t kMostAhead = kMostKept / 2;

  std::function<std::vector<Item>(std::size_t)> make_;
  std::size_t count_;
  mutable std::mutex mutex_;
  mutable std::list<std::pair<std::size_t, std::shared_future<Block>>> kept_;
};

}  // namespace graze::compare
