#pragma once

// Private to engine/mesh.

#include <graze/bvh/wide/wide_pair_walk.h>
#include <graze/engine/mesh/candidates.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/relative_frame.h>
#include <graze/engine/mesh/wide_counts.h>

namespace graze {

/// Two placed meshes that a query walks by their wide trees.
struct WideQuery {
  const PlacedMesh& a;
  const PlacedMesh& b;
  const bvh::WideTree& tree_a;
  const bvh::WideTree& tree_b;
  PlacedFrame frame_a;
  PlacedFrame frame_b;
  bvh::RelativeFrame b_in_a;

  /// Builds the tops of the trees if nobody has. Throws PoseError.
  WideQuery(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work& work)
      : WideQuery(mesh_a, mesh_b,
                  check_placement(mesh_a.pose, mesh_a.mesh.bounds(), "pose of mesh A"),
                  check_placement(mesh_b.pose, mesh_b.mesh.bounds(), "pose of mesh B"), work) {}

  /// Whether the boxes of all that there is prove it: far apart is the common case, which is over
  /// after one test.
  bool are_far_apart(Work& work) const {
    ++work.volume_tests;
    const bool is_apart = bvh::BoxSeparation(b_in_a).are_apart(tree_a.box(), tree_b.box());
    work.volume_rejections += is_apart;
    return is_apart;
  }

  bvh::WidePairWalk walk() const {
    return {tree_a, tree_b, b_in_a, relative_frame(frame_b, frame_a)};
  }

  TrianglePair pair_at(const bvh::PlacePair& places) const {
    return {tree_a.primitive(places.a), tree_b.primitive(places.b)};
  }

  Triangle triangle_a(TrianglePair pair) const { return place(a.pose, a.mesh.triangle(pair.a)); }
  Triangle triangle_b(TrianglePair pair) const { return place(b.pose, b.mesh.triangle(pair.b)); }

  /// Decides some of the pairs that a walk hands out; the rest of them wait in `candidates`.
  template <typename OnPair>
  bvh::Walk decide(std::span<const bvh::PlacePair> places, Candidates& candidates,
                   OnPair&& on_pair) const {
    for (const bvh::PlacePair& place : places) {
      const TrianglePair pair = pair_at(place);
      candidates.add(pair, triangle_a(pair), triangle_b(pair));
      if (candidates.is_full() && candidates.decide(on_pair) == bvh::Walk::Stop)
        return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  }

  /// All that a walk still finds. Calls `on_pair(pair)` for each that meets, until it answers Stop.
  template <typename OnPair>
  bvh::Walk decide_all(bvh::WidePairWalk& walk, Candidates& candidates, OnPair&& on_pair) const {
    bvh::PlacePair places[bvh::WidePairWalk::kMostAtOnce + Candidates::kCapacity];
    while (const std::size_t count = walk.next(places)) {
      if (decide({places, count}, candidates, on_pair) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return candidates.decide(on_pair);
  }

 private:
  WideQuery(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, double deviation_a,
            double deviation_b, Work& work)
      : a(mesh_a),
        b(mesh_b),
        tree_a(a.mesh.wide_tree(&work)),
        tree_b(b.mesh.wide_tree(&work)),
        frame_a{a.pose, deviation_a, tree_a.frame(), a.mesh.bounds()},
        frame_b{b.pose, deviation_b, tree_b.frame(), b.mesh.bounds()},
        b_in_a(relative_frame(frame_a, frame_b)) {}
};

}  // namespace graze
