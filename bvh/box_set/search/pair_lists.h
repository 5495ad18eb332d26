#pragma once

#include <graze/bvh/box_pair.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace graze::bvh {

/// A list of pairs whose new elements are not set to zero first. It keeps its memory when cleared.
class PairBuffer {
 public:
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  const BoxPair* data() const { return data_.get(); }
  BoxPair* data() { return data_.get(); }
  std::span<const BoxPair> pairs() const { return {data_.get(), size_}; }

  void clear() { size_ = 0; }
  void push_back(BoxPair pair) {
    *room_for(1) = pair;
    ++size_;
  }

  /// Returns where the next `count` pairs can be written; they belong to the list when set_end()
  /// says so.
  BoxPair* room_for(std::size_t count) {
    if (size_ + count > capacity_) grow(size_ + count);
    return data_.get() + size_;
  }
  void set_end(const BoxPair* end) { size_ = static_cast<std::size_t>(end - data_.get()); }
  void resize(std::size_t size) {
    if (size > capacity_) grow(size);
    size_ = size;
  }

 private:
  void grow(std::size_t wanted) {
    const std::size_t capacity = std::max(wanted, capacity_ + capacity_ / 2 + 64);
    std::unique_ptr<BoxPair[]> data(new BoxPair[capacity]);
    std::copy_n(data_.get(), size_, data.get());
    data_ = std::move(data);
    capacity_ = capacity;
  }

  std::unique_ptr<BoxPair[]> data_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// Writes the pairs in ascending order to `sorted`, which must not be `pairs`. All indices are
/// below `index_count`; `ends` is working memory. It takes O(pairs + index_count), and the time to
/// sort each row.
void sort_pairs(std::span<const BoxPair> pairs, std::uint32_t index_count,
                std::vector<std::uint32_t>& ends, PairBuffer& sorted);

/// Pairs grouped by their first index: row a is a list of pairs (a, b), in the order in which they
/// came.
class PairRows {
 public:
  /// Groups the pairs. All indices must be below `index_count`. It takes O(pairs + index_count).
  void group(std::span<const BoxPair> pairs, std::uint32_t index_count);

  std::uint32_t row_count() const { return static_cast<std::uint32_t>(ends_.size()); }
  /// Returns a row, which is empty beyond the last one.
  std::span<const BoxPair> row(std::uint32_t a) const {
    if (a >= ends_.size()) return {};
    const std::uint32_t first = a == 0 ? 0 : ends_[a - 1];
    return pairs_.pairs().subspan(first, ends_[a] - first);
  }
  std::size_t bytes() const {
    return pairs_.capacity() * sizeof(BoxPair) + ends_.capacity() * sizeof(std::uint32_t);
  }

 private:
  PairBuffer pairs_;
  std::vector<std::uint32_t> ends_;
};

/// The working memory of append_changes().
struct RowsToSort {
  std::vector<BoxPair> left, right;
};

/// Appends what is in `now` alone to `begun`, and what is in `before` alone to `ended`, ascending.
/// From one search to the next most rows are the same, and in the same order: these are not sorted.
void append_changes(const PairRows& before, const PairRows& now, RowsToSort& memory,
                    PairBuffer& begun, PairBuffer& ended);

}  // namespace graze::bvh
