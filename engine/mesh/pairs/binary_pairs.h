#pragma once

// This finds pairs of triangles by the binary trees of two meshes, whatever proves their nodes
// apart. It is private to engine/mesh.

#include <graze/bvh/traverse/traverse_pair.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <graze/engine/mesh/query/candidates.h>
#include <graze/engine/mesh/query/node_volumes.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

namespace graze {

/// Calls `on_pair(pair)` with the indices of each pair of triangles that meet, until it answers
/// Stop. `with_separation(frame, use)` calls `use(separation)` with what proves nodes apart.
template <typename WithSeparation, typename OnPair>
void for_each_binary_pair(const PlacedMeshView& a, const PlacedMeshView& b, Touch touch, Work& work,
                          WithSeparation&& with_separation, OnPair&& on_pair) {
  const double deviation_a = check_placement(a.pose, a.mesh.bounds(), "pose of mesh A");
  const double deviation_b = check_placement(b.pose, b.mesh.bounds(), "pose of mesh B");
  const bvh::Tree& tree_a = tree_of(a.mesh, &work);
  const bvh::Tree& tree_b = tree_of(b.mesh, &work);
  const bvh::RelativeFrame frame =
      relative_frame({a.pose, deviation_a, tree_a.frame, a.mesh.bounds()},
                     {b.pose, deviation_b, tree_b.frame, b.mesh.bounds()});
  Candidates candidates(touch, work);
  const auto collect = [&](const bvh::Node& leaf_a, const bvh::Node& leaf_b) {
    for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
      const std::uint32_t index_a = tree_a.primitives[i];
      const Triangle triangle_a = narrowphase::place(a.pose, a.mesh.triangle(index_a));
      for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
        const std::uint32_t index_b = tree_b.primitives[j];
        candidates.add({index_a, index_b}, triangle_a,
                       narrowphase::place(b.pose, b.mesh.triangle(index_b)));
        if (candidates.is_full() && candidates.decide(on_pair) == bvh::Walk::Stop)
          return bvh::Walk::Stop;
      }
    }
    return bvh::Walk::Continue;
  };
  with_separation(frame, [&](const auto& separation) {
    const CountedSeparation counted(separation, work);
    const bvh::Walk walk = bvh::traverse_pair(tree_a, tree_b, counted, collect);
    if (walk == bvh::Walk::Continue) candidates.decide(on_pair);
  });
}

}  // namespace graze
