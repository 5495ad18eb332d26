#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace graze::bvh {

/// The answer for each leaf, or pair, that a walk hands out: to go on, or that it is enough.
enum class Walk { Continue, Stop };

/// A stack that allocates only when it outgrows `InlineCapacity`, and then grows without limit: no
/// subtree is ever dropped.
template <typename Entry, std::size_t InlineCapacity>
class TraversalStack {
 public:
  /// Clears nothing: most stacks use little of their room, and would take longer to clear than a
  /// query of meshes far apart takes.
  TraversalStack() {}  // NOLINT(modernize-use-equals-default): that would clear where it is {}

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

  /// What came last and what came first change places.
  void swap_ends() { std::swap(at(0), at(size_ - 1)); }

  /// Takes every other entry out, from the first on, and hands each to `take(entry)`.
  template <typename Take>
  void take_half(Take&& take) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (i % 2 == 0) {
        take(at(i));
      } else {
        at(kept++) = at(i);
      }
    }
    size_ = kept;
    while (!spilled_.empty() && InlineCapacity + spilled_.size() > size_)
      spilled_.pop_back();
  }

 private:
  Entry& at(std::size_t index) {
    return index < InlineCapacity ? inline_[index] : spilled_[index - InlineCapacity];
  }

  std::array<Entry, InlineCapacity> inline_;
  std::vector<Entry> spilled_;
  std::size_t size_ = 0;
};

/// Two nodes that wait to be compared.
struct NodePair {
  std::uint32_t a;
  std::uint32_t b;
};

using PairStack = TraversalStack<NodePair, 256>;

/// Opens one node of a pair: its children, with the other node, are compared next.
inline void open_first(PairStack& stack, NodePair pair, std::uint32_t children) {
  stack.push({children + 1, pair.b});
  stack.push({children, pair.b});
}

inline void open_second(PairStack& stack, NodePair pair, std::uint32_t children) {
  stack.push({pair.a, children + 1});
  stack.push({pair.a, children});
}

}  // namespace graze::bvh
