#include <graze/engine/cli/view/shown_tree.h>

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>

#include <vector>

namespace graze::cli {
namespace {

/// More boxes than that hide what they are around.
constexpr std::size_t kMostBoxes = 4096;

Eigen::Vector3d point_of(const float (&numbers)[3]) {
  return {numbers[0], numbers[1], numbers[2]};
}

/// Returns a box of the tree's units in metres.
Obb in_metres(const bvh::LocalFrame& frame, const Eigen::Vector3d& centre,
              const Eigen::Matrix3d& turn, const Eigen::Vector3d& half) {
  Obb box{Pose::Identity(), half * frame.unit()};
  box.pose.linear() = turn;
  box.pose.translation() =
      Eigen::Vector3d(frame.centre[0], frame.centre[1], frame.centre[2]) + centre * frame.unit();
  return box;
}

Obb box_of(const bvh::LocalFrame& frame, const bvh::FloatBox& box) {
  const Eigen::Vector3d min = point_of(box.min), max = point_of(box.max);
  return in_metres(frame, (min + max) / 2, Eigen::Matrix3d::Identity(), (max - min) / 2);
}

Obb box_of(const bvh::LocalFrame& frame, const bvh::FloatObb& box) {
  Eigen::Matrix3d axes;
  for (int k = 0; k < 3; ++k)
    axes.col(k) = point_of(box.axes[k]);
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  // A rotation in floats is hardly one: this takes the nearest rotation, for the eye.
  return in_metres(frame, point_of(box.centre),
                   Eigen::Quaterniond(axes).normalized().toRotationMatrix(), point_of(box.half));
}

}  // namespace

std::optional<std::uint32_t> add_tree(const Mesh& mesh, TreeBoxes boxes, ViewBody body,
                                      View& view) {
  const bvh::Tree& tree = tree_of(mesh);
  std::span<const bvh::FloatObb> skin;
  if (boxes == TreeBoxes::Obb) skin = obb_skin_of(mesh);
  std::vector<std::uint32_t> level = {0};  // the nodes of one level
  for (std::uint32_t depth = 0; !level.empty(); ++depth) {
    if (level.size() > kMostBoxes) return depth;
    std::vector<Obb> found;
    std::vector<std::uint32_t> next;
    for (const std::uint32_t i : level) {
      const bvh::Node& node = tree.nodes[i];
      found.push_back(skin.empty() ? box_of(tree.frame, node.box) : box_of(tree.frame, skin[i]));
      if (!node.is_leaf()) next.insert(next.end(), {node.first, node.first + 1});
    }
    view.add_boxes(body, depth, found);
    level = std::move(next);
  }
  return std::nullopt;
}

}  // namespace graze::cli
