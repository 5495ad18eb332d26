#pragma once

// Walks a mesh's tree towards one convex shape. Private to engine/world.

#include <graze/bvh/traverse/traverse_nearest.h>
#include <graze/bvh/traverse/traverse_volume.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/convex/core/core.h>

#include <algorithm>
#include <span>

namespace graze {

/// A convex set in the frame of a mesh's tree, as a box around it, rounded outward, with the slack
/// of the transformation.
class MeshDescent {
 public:
  /// Takes the core to the mesh's frame. `origin` is that of the core's frame. The mesh must
  /// outlive the descent. Builds the mesh's tree if it is not there yet.
  MeshDescent(const PlacedMeshView& mesh, const narrowphase::Core& core,
              const Eigen::Vector3d& origin, Work& work);

  /// Calls `on_triangle(index)` for the triangles in leaves whose boxes meet the set's, until it
  /// answers Stop.
  template <typename OnTriangle>
  void for_each_near(OnTriangle&& on_triangle) {
    bvh::traverse_volume(
        tree_, [&](std::uint32_t node) { return is_apart(node); },
        [&](const bvh::Node& leaf) {
          for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
            const std::uint32_t index = tree_.primitives[i];
            if (is_triangle_apart(index)) continue;
            if (on_triangle(index) == bvh::Walk::Stop) return bvh::Walk::Stop;
          }
          return bvh::Walk::Continue;
        });
  }

  /// Calls `on_triangle(index)`, nearer nodes first, for the triangles that may be within
  /// `limit()`, metres, which may shrink on the way.
  template <typename OnTriangle, typename Limit>
  void for_each_within(Limit&& limit, OnTriangle&& on_triangle) {
    bvh::traverse_nearest(tree_, NodeBounds<Limit>{*this, limit},
                          [&](const bvh::Node& leaf) { return visit(leaf, limit, on_triangle); });
  }

  /// Returns a triangle in the world's frame (law 1).
  Triangle placed_triangle(std::uint32_t index) const;

  /// Returns a triangle in the form that the solvers take (placed by law 1, then relative to the
  /// origin).
  narrowphase::Core triangle(std::uint32_t index) const;

  /// True if the triangle's box is apart from the set's, both in the mesh's own frame. It has no
  /// branches, like is_apart(), because a CPU could not predict them.
  bool is_triangle_apart(std::uint32_t index) const {
    const TriangleIndices& t = triangles_[index];
    const double* a = vertices_[t[0]].data();
    const double* b = vertices_[t[1]].data();
    const double* c = vertices_[t[2]].data();
    bool is_apart = false;
    for (int k = 0; k < 3; ++k) {
      const double low = std::min(std::min(a[k], b[k]), c[k]);
      const double high = std::max(std::max(a[k], b[k]), c[k]);
      is_apart |= low > own_max_[k];
      is_apart |= high < own_min_[k];
    }
    return is_apart;
  }

  /// Returns a lower bound of the distance between the triangle and the set, metres.
  double triangle_bound(std::uint32_t index) const;

  const bvh::Tree& tree() const { return tree_; }
  /// Return the corners of the set's box in the tree's units, rounded outward.
  const double (&min() const)[3] { return min_; }
  const double (&max() const)[3] { return max_; }

 private:
  /// The bounds of nodes for traverse_nearest().
  template <typename Limit>
  struct NodeBounds {
    const MeshDescent& descent;
    Limit& limit;

    double of(std::uint32_t node) const { return descent.bound(node); }
    bool is_missed(double) const { return false; }
    bool is_beyond(double bound) const { return descent.is_beyond(bound, limit()); }
  };

  /// Returns a lower bound of the distance between the contents of a node and the set, metres.
  double bound(std::uint32_t node) const;
  double bound_of(const double (&low)[3], const double (&high)[3]) const;
  bool is_beyond(double bound, double limit) const;

  bool is_apart(std::uint32_t node) const {
    ++work_.volume_tests;
    const bvh::FloatBox& box = tree_.nodes[node].box;
    bool is_apart = false;
    for (int k = 0; k < 3; ++k) {
      is_apart |= box.min[k] > around_.max[k];
      is_apart |= box.max[k] < around_.min[k];
    }
    work_.volume_rejections += is_apart;
    return is_apart;
  }

  template <typename Limit, typename OnTriangle>
  bvh::Walk visit(const bvh::Node& leaf, Limit&& limit, OnTriangle&& on_triangle) const {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const std::uint32_t index = tree_.primitives[i];
      if (triangle_bound(index) > limit()) continue;
      if (on_triangle(index) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  }

  const PlacedMeshView& mesh_;
  const Eigen::Vector3d& origin_;
  const bvh::Tree& tree_;
  std::span<const Eigen::Vector3d> vertices_;
  std::span<const TriangleIndices> triangles_;
  Work& work_;
  double min_[3];  ///< the set's box, in the tree's units
  double max_[3];
  bvh::FloatBox around_;  ///< the same box, rounded outward
  double own_min_[3];     ///< the set's box in the mesh's frame, metres
  double own_max_[3];
  double unit_;    ///< the tree's unit, metres
  double shrink_;  ///< lengths in the mesh's frame are at most this much longer than in the world
};

}  // namespace graze
