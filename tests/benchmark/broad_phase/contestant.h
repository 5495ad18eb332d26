#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/box_pair.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace graze::benchmark {

/// A broad phase under measurement: boxes in, all pairs that overlap out, frame by frame.
class Contestant {
 public:
  virtual ~Contestant() = default;

  /// Takes all boxes; box i is known as i from here on.
  virtual void start(std::span<const Aabb> boxes) = 0;

  /// The boxes named in `moved`, ascending, have the places given in `boxes`, which lists all.
  /// Leaves each overlapping pair once in the span that it returns, smaller index first.
  virtual std::span<const BoxPair> step(std::span<const Aabb> boxes,
                                        std::span<const std::uint32_t> moved) = 0;

  /// The boxes named in `replaced` are gone, and new ones have come to the places given in `boxes`.
  /// For who begins anew in each frame that is a step like any other.
  virtual std::span<const BoxPair> replace(std::span<const Aabb> boxes,
                                           std::span<const std::uint32_t> replaced) {
    return step(boxes, replaced);
  }

  /// Which box the pairs call by this name.
  virtual std::uint32_t number(std::uint32_t name) const { return name; }

  /// Memory for the boxes beside the pairs; 0 where nobody counts it.
  virtual std::size_t bytes() const { return 0; }
};

struct Entry {
  std::string name;
  std::function<std::unique_ptr<Contestant>()> make;
  int threads = 1;
};

/// For what reports candidates only.
inline bool share_point(const Aabb& s, const Aabb& t) {
  return s.min[0] <= t.max[0] && t.min[0] <= s.max[0] && s.min[1] <= t.max[1] &&
         t.min[1] <= s.max[1] && s.min[2] <= t.max[2] && t.min[2] <= s.max[2];
}

inline BoxPair ordered_pair(std::uint32_t s, std::uint32_t t) {
  return {std::min(s, t), std::max(s, t)};
}

}  // namespace graze::benchmark
