#pragma once

#include <graze/bvh/tree/tree.h>

#include <algorithm>
#include <cmath>

namespace graze {

/// Proves nodes of two trees, or of one, further apart than a clearance, along an axis.
class NearNodes {
 public:
  NearNodes(const bvh::Tree& a, const bvh::Tree& b, double clearance) : a_(a), b_(b) {
    // Halves are taken, so that nothing overflows. Each end of a box is a sum that is off by 2^-53
    // of itself, and so are their difference and the limit: a sixteenth of the room.
    for (int k = 0; k < 3; ++k) {
      const double size = (0.5 * std::abs(a.frame.centre[k]) + 2 * half_unit(a)) +
                          (0.5 * std::abs(b.frame.centre[k]) + 2 * half_unit(b));
      limit_[k] = (0.5 * clearance + 0x1p-48 * size) * (1 + 0x1p-48) + 0x1p-1000;
    }
  }

  bool are_apart(std::uint32_t node_a, std::uint32_t node_b) const {
    const bvh::FloatBox &a = a_.nodes[node_a].box, &b = b_.nodes[node_b].box;
    bool is_apart = false;
    for (int k = 0; k < 3; ++k) {
      is_apart |= end(a_, k, a.min[k]) - end(b_, k, b.max[k]) > limit_[k];
      is_apart |= end(b_, k, b.min[k]) - end(a_, k, a.max[k]) > limit_[k];
    }
    return is_apart;
  }
  bool is_first_larger(std::uint32_t node_a, std::uint32_t node_b) const {
    return size_of(a_, node_a) >= size_of(b_, node_b);
  }

 private:
  static double half_unit(const bvh::Tree& tree) { return 0.5 * tree.frame.unit(); }
  /// Returns half of a coordinate, metres.
  static double end(const bvh::Tree& tree, int k, float local) {
    return 0.5 * tree.frame.centre[k] + double{local} * half_unit(tree);
  }
  static double size_of(const bvh::Tree& tree, std::uint32_t node) {
    const bvh::FloatBox& box = tree.nodes[node].box;
    double size = 0;
    for (int k = 0; k < 3; ++k)
      size += double{box.max[k]} - box.min[k];
    return size * half_unit(tree);
  }

  const bvh::Tree& a_;
  const bvh::Tree& b_;
  double limit_[3];
};

}  // namespace graze
