#include <graze/bvh/tree/tree.h>
#include <graze/engine/cli/reports/separated_boxes.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace graze::cli {
namespace {

constexpr std::array kAxisNames = {"x", "y", "z"};

struct PlacedBox {
  const Aabb& box;
  const Pose& pose;

  Eigen::Vector3d middle() const { return place(pose, Eigen::Vector3d(box.min / 2 + box.max / 2)); }
  double projected_radius(const Eigen::Vector3d& axis) const {
    const Eigen::Vector3d half = box.max / 2 - box.min / 2;
    return (pose.linear().transpose() * axis).cwiseAbs().dot(half);
  }
};

double gap_along(const Eigen::Vector3d& axis, const PlacedBox& a, const PlacedBox& b) {
  return std::abs(axis.dot(b.middle() - a.middle())) - a.projected_radius(axis) -
         b.projected_radius(axis);
}

/// Tries the fifteen directions in which two boxes can be apart (bvh/value/separating_axes.h). They
/// are computed in the world's frame and as unit vectors, because people read the direction and the
/// metres; no answer comes from here.
BoxAxis widest_axis(const PlacedBox& a, const PlacedBox& b) {
  BoxAxis best{"", Eigen::Vector3d::UnitX(), -std::numeric_limits<double>::infinity()};
  const auto offer = [&](const std::string& name, const Eigen::Vector3d& direction) {
    const double length = direction.norm();
    if (length < 1e-6) return;  // parallel edges have no axis of their own
    const Eigen::Vector3d unit = direction / length;
    const double gap = gap_along(unit, a, b);
    if (gap > best.gap) best = {name, unit, gap};
  };
  for (std::size_t i = 0; i < 3; ++i)
    offer(fmt::format("{} of A", kAxisNames[i]), a.pose.linear().col(static_cast<int>(i)));
  for (std::size_t j = 0; j < 3; ++j)
    offer(fmt::format("{} of B", kAxisNames[j]), b.pose.linear().col(static_cast<int>(j)));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      offer(
          fmt::format("{} of A cross {} of B", kAxisNames[i], kAxisNames[j]),
          a.pose.linear().col(static_cast<int>(i)).cross(b.pose.linear().col(static_cast<int>(j))));
    }
  }
  return best;
}

/// Follows the path from the root of a mesh's tree down to the leaf that holds a triangle.
class DescentPath {
 public:
  DescentPath(const PlacedMeshView& placed, std::uint32_t triangle)
      : pose_(placed.pose), tree_(tree_of(placed.mesh)) {
    const std::vector<std::uint32_t>& all = tree_.primitives;
    place_ = static_cast<std::size_t>(std::find(all.begin(), all.end(), triangle) - all.begin());
    end_ = all.size();
    set_box();
  }

  bool is_at_leaf() const { return node().is_leaf(); }
  std::size_t triangles() const { return end_ - begin_; }
  PlacedBox box() const { return {box_, pose_}; }
  double diagonal() const { return (box_.max - box_.min).norm(); }

  void descend() {
    const std::uint32_t second = node().first + 1;
    const std::size_t middle = first_place(second);
    if (place_ < middle) {
      node_ = node().first;
      end_ = middle;
    } else {
      node_ = second;
      begin_ = middle;
    }
    set_box();
  }

 private:
  const bvh::Node& node() const { return tree_.nodes[node_]; }

  std::size_t first_place(std::uint32_t node) const {
    while (!tree_.nodes[node].is_leaf())
      node = tree_.nodes[node].first;
    return tree_.nodes[node].first;
  }

  void set_box() {
    for (int k = 0; k < 3; ++k) {
      const double centre = tree_.frame.centre[k];
      const double unit = tree_.frame.unit();
      box_.min[k] = centre + unit * static_cast<double>(node().box.min[k]);
      box_.max[k] = centre + unit * static_cast<double>(node().box.max[k]);
    }
  }

  const Pose& pose_;
  const bvh::Tree& tree_;
  std::size_t place_ = 0;  ///< the triangle's place in the order of the leaves
  std::size_t begin_ = 0;  ///< the node's triangles are from here to `end_` in that order
  std::size_t end_ = 0;
  std::uint32_t node_ = 0;
  Aabb box_;
};

}  // namespace

BoxAxis widest_axis(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b) {
  return widest_axis(PlacedBox{mesh_a.mesh.bounds(), mesh_a.pose},
                     PlacedBox{mesh_b.mesh.bounds(), mesh_b.pose});
}

std::optional<SeparatedBoxes> separated_boxes(const PlacedMeshView& mesh_a,
                                              const PlacedMeshView& mesh_b, TrianglePair pair) {
  DescentPath a(mesh_a, pair.a);
  DescentPath b(mesh_b, pair.b);
  for (;;) {
    const BoxAxis axis = widest_axis(a.box(), b.box());
    if (axis.gap > 0) return SeparatedBoxes{a.triangles(), b.triangles(), axis};
    if (a.is_at_leaf() && b.is_at_leaf()) return std::nullopt;
    DescentPath& larger =
        b.is_at_leaf() || (!a.is_at_leaf() && a.diagonal() >= b.diagonal()) ? a : b;
    larger.descend();
  }
}

}  // namespace graze::cli
