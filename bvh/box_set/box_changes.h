#pragma once

#include <graze/bvh/aabb.h>

#include <cstdint>
#include <vector>

namespace graze::bvh {

/// What is to happen to boxes at the next update, in the order in which it was asked for. A box may
/// be named more than once: the last entry counts.
struct BoxChanges {
  enum class Kind : std::uint8_t { Insert, Move, Erase };

  std::vector<std::uint32_t> owner;
  std::vector<Aabb> box;
  std::vector<Kind> kind;
  std::size_t moves = 0;

  std::size_t size() const { return owner.size(); }
  void add(std::uint32_t of, const Aabb& to, Kind what) {
    owner.push_back(of);
    box.push_back(to);
    kind.push_back(what);
    moves += what == Kind::Move;
  }
  void clear() {
    owner.clear(), box.clear(), kind.clear();
    moves = 0;
  }
};

}  // namespace graze::bvh
