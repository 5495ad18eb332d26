#pragma once

#include <graze/bvh/box_pair.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

namespace graze::bvh {

/// A list of pairs whose new elements are not set to zero first. Keeps its memory when cleared.
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

  /// Where the next `count` pairs can be written; they belong to the list when set_end() says so.
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

}  // namespace graze::bvh
