#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/narrowphase/triangle.h>

namespace graze::compare {

/// This is the referee's own hierarchy: boxes of doubles, halved at the median. A node is halved
/// when a walk first comes to it: most trees are walked once, and along a few ways. One thread may
/// use it at a time, unless all nodes are halved.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Triangle> triangles);

  /// Halves all nodes. From then on a walk changes nothing, and many threads may walk.
  void halve_all();

  /// Calls `on_pair(i, j)` for triangles whose boxes share a point, until it returns false. The
  /// trees are of two frames, and the boxes are placed by law 1's operations, each rounded, on the
  /// ends of the box; each of them is monotone in every operand. So a box holds each placed corner
  /// of its triangles to the bit, and no bound is needed.
  static void for_each_placed_overlap(
      const BoxTree& tree_a, const Pose& pose_a, const BoxTree& tree_b, const Pose& pose_b,
      const std::function<bool(std::uint32_t, std::uint32_t)>& on_pair);

  // Boxes of one frame are only compared, so that nothing is rounded.

  /// Calls `on_pair(i, j)` for triangles whose boxes share a point, until it returns false.
  static void for_each_overlap(const BoxTree& tree_a, const BoxTree& tree_b,
                               const std::function<bool(std::uint32_t, std::uint32_t)>& on_pair);

  /// Calls `on_pair(i, j)` for triangles whose boxes are nearer than the bound that it last
  /// returned, metres, beginning with `bound`; nearer nodes first.
  static void for_each_nearer(const BoxTree& tree_a, const BoxTree& tree_b, double bound,
                              const std::function<double(std::uint32_t, std::uint32_t)>& on_pair);

 private:
  struct Box {
    std::array<double, 3> min;
    std::array<double, 3> max;
  };
  struct Node {
    Box box;
    std::uint32_t first;  ///< the first of its triangles in order_
    std::uint32_t count;
    std::uint32_t left;  ///< 0 until it is halved; the right child is the next one
    bool is_leaf() const;
  };
  struct OverlapWalk;
  struct PlacedWalk;
  struct NearWalk;

  static Box box_of(const Triangle& triangle);
  static void include(Box& box, const Box& other);
  static bool overlap(const Box& a, const Box& b);
  static Box placed(const Pose& pose, const Box& box);
  static double gap_below(const Box& a, const Box& b);
  Node node_of(std::uint32_t first, std::uint32_t count) const;
  std::uint32_t left_of(std::uint32_t node) const;

  std::vector<Box> boxes_;
  mutable std::vector<std::uint32_t> order_;
  mutable std::vector<Node> nodes_;  ///< nodes are never moved: there is room for all
};

}  // namespace graze::compare
