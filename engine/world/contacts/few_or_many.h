#pragma once

// This is a list that is mostly short. It is private to engine/world.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace graze {

/// A list whose first `kFew` elements take no memory beyond its own, so that lists of lists lie in
/// a row and are gone through without a cache miss for each. Elements are assigned over and
/// destroyed with the list; the list keeps the memory that it once took.
template <typename T, std::size_t kFew>
class FewOrMany {
 public:
  std::size_t size() const { return count_; }
  std::span<T> all() { return {data(), count_}; }
  std::span<const T> all() const { return {is_few() ? few_.data() : many_.data(), count_}; }
  T& back() { return data()[count_ - 1]; }

  void clear() { count_ = 0; }
  void push_back(T&& element) {
    if (count_ < kFew) {
      few_[count_] = std::move(element);
    } else {
      many_.resize(count_ + 1);
      if (count_ == kFew) std::move(few_.begin(), few_.end(), many_.begin());
      many_[count_] = std::move(element);
    }
    ++count_;
  }
  /// Replaces the elements by these.
  void assign(std::span<const T> elements) {
    if (elements.size() > kFew) {
      many_.assign(elements.begin(), elements.end());
    } else {
      std::copy(elements.begin(), elements.end(), few_.begin());
    }
    count_ = elements.size();
  }

 private:
  bool is_few() const { return count_ <= kFew; }
  T* data() { return is_few() ? few_.data() : many_.data(); }

  std::size_t count_ = 0;
  std::array<T, kFew> few_{};
  std::vector<T> many_;  ///< all of them, if there are more than a few
};

}  // namespace graze
