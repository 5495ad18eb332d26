#pragma once

// This is private to engine/mesh.

#include <graze/bvh/wide/walk/wide_pair_walk.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <graze/engine/mesh/query/candidates.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>
#include <hwy/cache_control.h>

#include <cassert>

namespace graze {

/// The triangles of a placed mesh, one by one.
struct PlacedTriangles {
  const Pose& pose;
  std::span<const Eigen::Vector3d> vertices;
  std::span<const TriangleIndices> triangles;

  explicit PlacedTriangles(const PlacedMeshView& placed)
      : pose(placed.pose), vertices(placed.mesh.vertices()), triangles(placed.mesh.triangles()) {}

  Triangle operator[](std::uint32_t index) const {
    const TriangleIndices& t = triangles[index];
    return narrowphase::place(pose, {vertices[t[0]], vertices[t[1]], vertices[t[2]]});
  }

  /// Fetch a triangle's indices and its corners. Large meshes are not in the cache, and where a
  /// triangle's corners stand is known last.
  void prefetch_indices(std::uint32_t index) const { hwy::Prefetch(&triangles[index]); }
  void prefetch_corners(std::uint32_t index) const {
    for (const std::uint32_t corner : triangles[index])
      hwy::Prefetch(&vertices[corner]);
  }
};

inline void add_counts(const bvh::TreeletCounts& counts, Work& work) {
  work.treelets_built += counts.built;
  work.treelets_refitted += counts.refitted;
}

inline void add_counts(const bvh::WideWalkCounts& counts, Work& work) {
  work.volume_tests += counts.box_tests;
  work.volume_rejections += counts.box_rejections;
  add_counts(counts.treelets, work);
  work.filter_tests += counts.primitive_tests;
}

/// Two placed meshes that a query walks by their wide trees.
struct WideQuery {
  const PlacedMeshView& a;
  const PlacedMeshView& b;
  const bvh::WideTree& tree_a;
  const bvh::WideTree& tree_b;
  PlacedTriangles triangles_a;
  PlacedTriangles triangles_b;
  PlacedFrame frame_a;
  PlacedFrame frame_b;
  bvh::RelativeFrame b_in_a;

  /// Builds the tops of the trees if nobody has. Throws PoseError.
  WideQuery(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Work& work)
      : WideQuery(mesh_a, mesh_b,
                  check_placement(mesh_a.pose, mesh_a.mesh.bounds(), "pose of mesh A"),
                  check_placement(mesh_b.pose, mesh_b.mesh.bounds(), "pose of mesh B"), work) {}

  /// Builds a query of poses that have been checked.
  WideQuery(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, double deviation_a,
            double deviation_b, Work& work)
      : a(mesh_a),
        b(mesh_b),
        tree_a(wide_tree_of(a.mesh, &work)),
        tree_b(wide_tree_of(b.mesh, &work)),
        triangles_a(a),
        triangles_b(b),
        frame_a{a.pose, deviation_a, tree_a.frame(), a.mesh.bounds()},
        frame_b{b.pose, deviation_b, tree_b.frame(), b.mesh.bounds()},
        b_in_a(relative_frame(frame_a, frame_b)) {}

  /// True if the boxes of all that there is prove that the meshes are apart: far apart is the
  /// common case, which is over after one test.
  bool are_far_apart(Work& work) const {
    ++work.volume_tests;
    const bool is_apart = bvh::are_apart_along_faces(b_in_a, tree_a.box(), tree_b.box());
    work.volume_rejections += is_apart;
    return is_apart;
  }

  bvh::RelativeFrame a_in_b() const { return reversed(b_in_a, frame_a, frame_b); }

  bvh::WidePairWalk walk(bvh::WidePairWalk::Goal goal) const {
    return {tree_a, tree_b, b_in_a, a_in_b(), goal};
  }

  TrianglePair pair_at(const bvh::PlacePair& places) const {
    return {tree_a.primitive(places.a), tree_b.primitive(places.b)};
  }

  Triangle triangle_a(TrianglePair pair) const { return triangles_a[pair.a]; }
  Triangle triangle_b(TrianglePair pair) const { return triangles_b[pair.b]; }

  /// Decides some of the pairs that a walk hands out; the rest of them wait in `candidates`.
  template <typename OnPair>
  bvh::Walk decide_found(std::span<const bvh::FoundPair> found, Candidates& candidates,
                         OnPair&& on_pair) const {
    for (std::size_t i = 0; i < found.size(); ++i) {
      prefetch_ahead(found, i);
      const TrianglePair pair = pair_at(found[i].places);
      if (found[i].do_cross) {
        candidates.add_crossing(pair);
      } else {
        candidates.add(pair, triangle_a(pair), triangle_b(pair));
      }
      if (candidates.is_full() && candidates.decide(on_pair) == bvh::Walk::Stop)
        return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  }

  /// Decides all that a walk to all pairs still finds. Calls `on_pair(pair)` for each pair that
  /// meets, until it answers Stop.
  template <typename OnPair>
  bvh::Walk decide_all(bvh::WidePairWalk& walk, Candidates& candidates, OnPair&& on_pair) const {
    assert(walk.goal() == bvh::WidePairWalk::Goal::AllPairs);
    bvh::FoundPair found[bvh::WidePairWalk::kMany];
    while (const std::size_t count = walk.next(found)) {
      if (decide_found({found, count}, candidates, on_pair) == bvh::Walk::Stop)
        return bvh::Walk::Stop;
    }
    return candidates.decide(on_pair);
  }

  /// Does the same, in the same order, for a query that the first of these pairs ends: what each
  /// round of next() has found is decided before the next round.
  template <typename OnPair>
  bvh::Walk decide_first_in_order(bvh::WidePairWalk& walk, Candidates& candidates,
                                  OnPair&& on_pair) const {
    assert(walk.goal() == bvh::WidePairWalk::Goal::AllPairs);
    // With room for one step a round ends after the first step that finds any.
    bvh::FoundPair found[bvh::WidePairWalk::kMostInStep];
    while (const std::size_t count = walk.next(found)) {
      if (decide_found({found, count}, candidates, on_pair) == bvh::Walk::Stop)
        return bvh::Walk::Stop;
      if (candidates.decide(on_pair) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  }

  /// Does the same, in any order, for a query that any pair ends, with a walk to any pair: what one
  /// round of next() has found is decided before the next round, for it is likely to be the last.
  template <typename OnPair>
  bvh::Walk decide_any(bvh::WidePairWalk& walk, Candidates& candidates, OnPair&& on_pair) const {
    assert(walk.goal() == bvh::WidePairWalk::Goal::AnyPair);
    bvh::FoundPair found[bvh::WidePairWalk::kMostAtOnce];
    while (const std::size_t count = walk.next(found)) {
      // If `on_pair` goes on all the same, decide_found() hands these up a second time.
      for (std::size_t i = 0; i < count; ++i) {
        if (found[i].do_cross && on_pair(pair_at(found[i].places)) == bvh::Walk::Stop)
          return bvh::Walk::Stop;
      }
      if (decide_found({found, count}, candidates, on_pair) == bvh::Walk::Stop)
        return bvh::Walk::Stop;
      if (candidates.decide(on_pair) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  }

 private:
  void prefetch_ahead(std::span<const bvh::FoundPair> found, std::size_t i) const {
    constexpr std::size_t kIndicesAhead = 8;
    constexpr std::size_t kCornersAhead = 4;
    if (i + kIndicesAhead < found.size() && !found[i + kIndicesAhead].do_cross) {
      const TrianglePair pair = pair_at(found[i + kIndicesAhead].places);
      triangles_a.prefetch_indices(pair.a);
      triangles_b.prefetch_indices(pair.b);
    }
    if (i + kCornersAhead < found.size() && !found[i + kCornersAhead].do_cross) {
      const TrianglePair pair = pair_at(found[i + kCornersAhead].places);
      triangles_a.prefetch_corners(pair.a);
      triangles_b.prefetch_corners(pair.b);
    }
  }
};

}  // namespace graze
