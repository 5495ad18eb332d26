#pragma once

// These hand back what queries find. They are private to the library. Each query has one function
// that calls `on_item(item)` for all there is to find, until it answers Stop; the rest is the same
// for all.

#include <graze/bvh/traverse/traversal.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/query/sort_pairs.h>
#include <graze/engine/work.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace graze {

/// A query's own counters, which go to the caller's, if there are any, when the query ends.
class CountedWork {
 public:
  explicit CountedWork(Work* total) : total_(total) {}
  ~CountedWork() {
    if (total_ != nullptr) *total_ += work_;
  }
  CountedWork(const CountedWork&) = delete;
  CountedWork& operator=(const CountedWork&) = delete;

  Work& work() { return work_; }

 private:
  Work work_;
  Work* total_;
};

/// True if there is anything to find.
template <typename ForEach>
bool has_any(ForEach&& for_each) {
  bool is_found = false;
  for_each([&](const auto&) {
    is_found = true;
    return bvh::Walk::Stop;
  });
  return is_found;
}

/// Fills `items` with at most `limit` of all there is to find, sorted. One more is looked for, to
/// know whether these are all.
template <typename Item, typename ForEach>
Completeness collect(std::vector<Item>& items, std::size_t limit, ForEach&& for_each) {
  Completeness completeness = Completeness::Complete;
  for_each([&](const Item& item) {
    if (items.size() == limit) {
      completeness = Completeness::LimitReached;
      return bvh::Walk::Stop;
    }
    items.push_back(item);
    return bvh::Walk::Continue;
  });
  if constexpr (std::is_same_v<Item, TrianglePair>) {
    sort_pairs(items);
  } else {
    std::sort(items.begin(), items.end());
  }
  return completeness;
}

}  // namespace graze
