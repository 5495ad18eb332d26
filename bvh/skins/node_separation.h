#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/tree/tree.h>
#include <cstdint>
#include <span>

namespace graze::bvh {

/// Proves pairs of nodes apart by the boxes that the nodes themselves hold.
class NodeSeparation {
 public:
  NodeSeparation(const RelativeFrame& frame, std::span<const Node> nodes_a,
                 std::span<const Node> nodes_b)
      : boxes_(frame), nodes_a_(nodes_a), nodes_b_(nodes_b) {}

  bool are_apart(std::uint32_t a, std::uint32_t b) const {
    return boxes_.are_apart(nodes_a_[a].box, nodes_b_[b].box);
  }
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const {
    return boxes_.is_first_larger(nodes_a_[a].box, nodes_b_[b].box);
  }

 private:
  BoxSeparation boxes_;
  std::span<const Node> nodes_a_;
  std::span<const Node> nodes_b_;
};

/// Proves pairs of nodes of two trees in one frame apart: boxes that share no point are apart,
/// exactly.
class NodeOverlap {
 public:
  NodeOverlap(std::span<const Node> nodes_a, std::span<const Node> nodes_b)
      : nodes_a_(nodes_a), nodes_b_(nodes_b) {}

  bool are_apart(std::uint32_t a, std::uint32_t b) const {
    return !overlap(nodes_a_[a].box, nodes_b_[b].box);
  }
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const {
    return half_surface(nodes_a_[a].box) >= half_surface(nodes_b_[b].box);
  }

 private:
  std::span<const Node> nodes_a_;
  std::span<const Node> nodes_b_;
};

}  // namespace graze::bvh
