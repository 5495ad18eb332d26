#pragma once

#include <graze/bvh/tree/tree.h>
#include <graze/bvh/value/lanes.h>

namespace graze::bvh {

/// A Node as it lies in memory: its minimum and max[0] in one register, the rest of its maximum,
/// first and count in the other.
struct NodeLanes {
  Lanes low;
  Lanes high;
};
static_assert(sizeof(NodeLanes) == sizeof(Node));

/// Returns the node, made in registers.
static inline Node node_over(const Bounds& box, std::uint32_t first, std::uint32_t count) {
  const Lanes min = -box.minus_min;
  const Lanes across = __builtin_shufflevector(min, box.max, 2, 2, 4, 4);
  const IntLanes rest = {static_cast<std::int32_t>(first), static_cast<std::int32_t>(count), 0, 0};
  return std::bit_cast<Node>(
      NodeLanes{__builtin_shufflevector(min, across, 0, 1, 4, 6),
                __builtin_shufflevector(box.max, std::bit_cast<Lanes>(rest), 1, 2, 4, 5)});
}

/// Returns the inner node around both children.
static inline Node node_around(const Node& a, const Node& b, std::uint32_t first) {
  constexpr IntLanes kOfMax = {0, 0, 0, -1};
  const auto lanes_a = std::bit_cast<NodeLanes>(a);
  const auto lanes_b = std::bit_cast<NodeLanes>(b);
  const Lanes low =
      chosen(kOfMax, larger(lanes_a.low, lanes_b.low), smaller(lanes_a.low, lanes_b.low));
  const IntLanes rest = {static_cast<std::int32_t>(first), 0, 0, 0};
  const Lanes high = larger(lanes_a.high, lanes_b.high);
  return std::bit_cast<Node>(
      NodeLanes{low, __builtin_shufflevector(high, std::bit_cast<Lanes>(rest), 0, 1, 4, 5)});
}

}  // namespace graze::bvh
