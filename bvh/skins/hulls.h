#pragma once

#include <graze/bvh/tree/tree.h>
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// The primitives of a tree as the convex hulls of few points each, in the order of its leaves and
/// in its LocalFrame. The points of one node lie side by side, so that each volume is fitted to a
/// span. Local coordinates are rounded to double: off by at most kRounding.
class Hulls {
 public:
  static constexpr double kRounding = 0x1p-51;

  /// Takes `points`, which holds `per_primitive` points for each primitive of the tree, in the
  /// order of the primitives' indices. It takes linear time. Throws InputError for another number
  /// of points.
  Hulls(const Tree& tree, std::span<const Eigen::Vector3d> points, std::size_t per_primitive);

  /// Returns the points of all primitives below a node.
  std::span<const Eigen::Vector3d> below(std::size_t node) const;

 private:
  struct Range {
    std::uint32_t first;
    std::uint32_t end;
  };

  std::vector<Eigen::Vector3d> points_;
  std::vector<Range> primitives_below_;  ///< the primitives below each node
  std::size_t per_primitive_;
};

}  // namespace graze::bvh
