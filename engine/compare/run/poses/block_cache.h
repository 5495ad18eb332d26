#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace graze::compare {

/// A long list that is made block by block where it is needed, and of which the blocks that were
/// needed last are kept. May be read from many threads; who needs a block that another one is
/// making waits for it.
template <typename Item>
class BlockCache {
 public:
  using Block = std::shared_ptr<const std::vector<Item>>;

  explicit BlockCache(std::function<std::vector<Item>(std::size_t block)> make)
      : make_(std::move(make)) {}

  /// Throws what making it throws.
  Block at(std::size_t block) const {
    std::promise<Block> promise;
    std::shared_future<Block> future;
    bool is_mine = false;
    {
      const std::lock_guard lock(mutex_);
      const auto found = std::find_if(kept_.begin(), kept_.end(),
                                      [&](const auto& each) { return each.first == block; });
      if (found != kept_.end()) {
        kept_.splice(kept_.begin(), kept_, found);
      } else {
        is_mine = true;
        kept_.emplace_front(block, promise.get_future().share());
        if (kept_.size() > kMostKept) kept_.pop_back();
      }
      future = kept_.front().second;
    }
    if (is_mine) {
      try {
        promise.set_value(std::make_shared<const std::vector<Item>>(make_(block)));
      } catch (...) {
        promise.set_exception(std::current_exception());
      }
    }
    return future.get();
  }

 private:
  static constexpr std::size_t kMostKept = 16;

  std::function<std::vector<Item>(std::size_t)> make_;
  mutable std::mutex mutex_;
  mutable std::list<std::pair<std::size_t, std::shared_future<Block>>> kept_;
};

}  // namespace graze::compare
