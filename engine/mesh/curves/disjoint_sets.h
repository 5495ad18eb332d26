#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace graze::contacts {

/// Numbers joined into sets, each known by its lowest number.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  void join(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t root_i = lowest(i);
    const std::uint32_t root_j = lowest(j);
    parent_[root_i < root_j ? root_j : root_i] = root_i < root_j ? root_i : root_j;
  }

  std::uint32_t lowest(std::uint32_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace graze::contacts
