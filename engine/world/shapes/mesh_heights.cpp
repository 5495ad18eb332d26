#include <graze/bvh/traverse/traverse_nearest.h>
#include <graze/bvh/traverse/traverse_volume.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shapes/mesh_heights.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

using narrowphase::Vec3;

namespace {

/// Bounds nodes for traverse_nearest(), by a lower bound of the height of their contents.
template <typename Bound>
struct HeightBounds {
  const Bound& bound;
  const double& best;

  double of(std::uint32_t node) const { return bound(node); }
  bool is_missed(double) const { return false; }
  bool is_beyond(double height) const { return height >= best; }
};

}  // namespace

// The slack is that of MeshDescent, whose box this plane stands in for.
MeshHeights::MeshHeights(const PlacedMeshView& mesh, const PlacedHalfSpace& plane,
                         const Eigen::Vector3d& origin, Work& work)
    : mesh_(mesh),
      plane_(plane),
      origin_(to_vec3(origin)),
      work_(work),
      tree_(tree_of(mesh.mesh, &work)) {
  const double* m = mesh.pose.data();
  const Vec3 from_mesh = origin_ - Vec3{m[12], m[13], m[14]};
  base_ = -plane.offset - dot(plane.normal, from_mesh);
  for (int k = 0; k < 3; ++k) {
    own_[k] = dot(plane.normal, Vec3{m[4 * k], m[4 * k + 1], m[4 * k + 2]});
    base_ += own_[k] * tree_.frame.centre[k];
  }
  const Aabb& box = mesh.mesh.bounds();
  const double size = 2 * (largest(to_vec3(box.min)) + largest(to_vec3(box.max))) +
                      2 * largest(from_mesh) + std::abs(plane.offset);
  const double law_1 = std::max(std::abs(m[12]), std::max(std::abs(m[13]), std::abs(m[14])));
  slack_ = 0x40p-53 * size + 0x10p-53 * law_1 + plane.slack;
}

Vec3 MeshHeights::place(std::uint32_t index) const {
  return to_vec3(narrowphase::place(mesh_.pose, mesh_.mesh.vertices()[index])) - origin_;
}

double MeshHeights::of_vertex(std::uint32_t index) const {
  return dot(plane_.normal, place(index)) - plane_.offset;
}

MeshHeights::Range MeshHeights::of_node(std::uint32_t node) const {
  ++work_.volume_tests;
  const bvh::FloatBox& box = tree_.nodes[node].box;
  double low = 0, high = 0;
  for (int k = 0; k < 3; ++k) {
    const double at_min = own_[k] * box.min[k], at_max = own_[k] * box.max[k];
    low += std::min(at_min, at_max);
    high += std::max(at_min, at_max);
  }
  const double unit = tree_.frame.unit();
  return {base_ + low * unit - slack_, base_ + high * unit + slack_};
}

Height MeshHeights::lowest(double enough) const {
  Height best{std::numeric_limits<double>::infinity(), slack_, {}};
  const auto bound = [&](std::uint32_t node) { return of_node(node).low; };
  bvh::traverse_nearest(
      tree_, HeightBounds<decltype(bound)>{bound, best.height}, [&](const bvh::Node& leaf) {
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
          for (const std::uint32_t index : mesh_.mesh.triangles()[tree_.primitives[i]]) {
            const Vec3 point = place(index);
            const double height = dot(plane_.normal, point) - plane_.offset;
            if (height < best.height) best.height = height, best.lowest = point;
          }
        }
        return best.height > enough ? bvh::Walk::Continue : bvh::Walk::Stop;
      });
  return best;
}

std::optional<std::uint32_t> MeshHeights::find_crossed() const {
  const auto is_apart = [&](std::uint32_t node) {
    const Range range = of_node(node);
    const bool apart = range.low > slack_ || range.high < -slack_;
    work_.volume_rejections += apart;
    return apart;
  };
  std::optional<std::uint32_t> found;
  bvh::traverse_volume(tree_, is_apart, [&](const bvh::Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const TriangleIndices& corners = mesh_.mesh.triangles()[tree_.primitives[i]];
      double low = of_vertex(corners[0]), high = low;
      for (const std::uint32_t index : {corners[1], corners[2]}) {
        const double height = of_vertex(index);
        low = std::min(low, height);
        high = std::max(high, height);
      }
      if (low > slack_ || high < -slack_) continue;
      found = tree_.primitives[i];
      return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  });
  return found;
}

}  // namespace graze
