#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace graze::bvh {

/// What a leaf function answers.
enum class Walk { Continue, Stop };

/// A stack that allocates only when it outgrows `InlineCapacity`, and then grows without limit: no
/// subtree is ever dropped.
template <typename Entry, std::size_t InlineCapacity>
class TraversalStack {
 public:
  bool empty() const { return size_ == 0; }

  void push(const Entry& entry) {
    if (size_ < InlineCapacity) {
      inline_[size_] = entry;
    } else {
      spilled_.push_back(entry);
    }
    ++size_;
  }

  Entry pop() {
    --size_;
    if (size_ < InlineCapacity) return inline_[size_];
    const Entry entry = spilled_.back();
    spilled_.pop_back();
    return entry;
  }

 private:
  std::array<Entry, InlineCapacity> inline_;
  std::vector<Entry> spilled_;
  std::size_t size_ = 0;
};

}  // namespace graze::bvh
